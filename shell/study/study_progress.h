// SPDX-License-Identifier: MIT
// How far a study is, from the files of its shards: what is finished, what is not, and which shards have no
// file.
#pragma once

#include <functional>
#include <vector>

#include "shell/study/study_file.h"

namespace gaitsmith::shell {

class StudyProgress {
 public:
  /// @param noun what is counted, "trials"
  StudyProgress(std::size_t total, std::string_view noun) : noun_(noun), done_(total) {}

  /// @param trials finished ones in a file of this study, by canonical index
  void Add(const std::string& path, const Shard& shard, const std::map<std::size_t, StudyFile::Rows>& trials);
  /// A file whose writer has not written the heading yet.
  void AddWithoutHeading(const std::string& path);

  /// The number of trials that no file holds.
  [[nodiscard]] std::size_t Missing() const;

  /// `shard,of,done,due,state,file`: a row for each file and for each shard that has no file but trials that
  /// are missing, by shard, and a last one for all.
  [[nodiscard]] std::string Csv() const;

  /// "3 of 8 trials are missing: shard 2/3 has no file; shard 1/3 is not finished (r1.csv)". With files that
  /// name no shard: "3 of 8 trials are missing, first that of …".
  /// @param name of a trial
  [[nodiscard]] std::string Sentence(const std::function<std::string(std::size_t)>& name) const;

 private:
  struct Row {
    Shard shard;
    std::size_t done;
    std::string path;  // empty: no file
    bool headed = true;
  };
  [[nodiscard]] std::vector<Row> Rows() const;
  [[nodiscard]] std::size_t DoneIn(const Shard& shard) const;

  std::string noun_;
  std::vector<bool> done_;  // by canonical index
  std::vector<Row> files_;
};

}  // namespace gaitsmith::shell
