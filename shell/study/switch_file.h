// SPDX-License-Identifier: MIT
// A shard of `gaitsmith switches` as text. What counts as a trial is an ordered pair of controllers, with the
// switches at all its times.
#pragma once

#include "shell/study/study_file.h"

namespace gaitsmith::shell {

struct SwitchFile {
  std::string fingerprint;          // 16 hexadecimal digits computed from all documents and options
  int times = 1;                    // switches of each pair
  std::vector<std::string> labels;  // of the documents, no two the same, at least two
  Shard shard = {};
  std::map<std::size_t, StudyFile::Rows> trials = {};  // by pair

  struct Pair {
    std::size_t from, to;
  };
  /// Ordered pairs of different documents.
  [[nodiscard]] std::size_t Total() const { return labels.size() * (labels.size() - 1); }
  /// Pairs in the order of the rows. @param pair below Total()
  [[nodiscard]] Pair At(std::size_t pair) const;
  /// "walk to jump"
  [[nodiscard]] std::string NameOfTrial(std::size_t pair) const;

  /// The first two lines of a shard; of the whole only the names of the columns.
  [[nodiscard]] std::string Heading() const;
  /// Heading and rows in order. All pairs give the bytes of a run without shards.
  [[nodiscard]] std::string Text() const;

  /// Whether a text begins like a shard of switches.
  [[nodiscard]] static bool Begins(std::string_view text);
  /// Checks every row. @param path for the error, which names file and line
  [[nodiscard]] static Result<SwitchFile> Parse(std::string_view text, const std::string& path, Ending);
};

}  // namespace gaitsmith::shell
