// SPDX-License-Identifier: MIT
// A study's file on disk while its trials run: each is appended as it finishes, so that whoever kills the
// program loses only trials under way, and the same command continues.
#pragma once

#include "shell/study/study_file.h"

namespace gaitsmith::shell {

class StudyLog {
 public:
  /// Opens or creates the file for this process alone and reads the trials in it; changes nothing yet.
  /// Refused: a file of another study or of none, a damaged row, a file that another process writes.
  [[nodiscard]] static Result<StudyLog> Open(const std::string& path, const StudyPlan&, StudyTable);
  StudyLog(StudyLog&&) noexcept;
  StudyLog& operator=(StudyLog&&) = delete;
  /// An empty file that was created and not begun goes again.
  ~StudyLog();

  [[nodiscard]] StudyTable Table() const { return file_.table; }
  [[nodiscard]] bool Has(std::size_t trial) const { return file_.trials.contains(trial); }
  /// Writes the heading, or drops a torn end.
  [[nodiscard]] Result<void> Begin();
  /// Whether a trial that is there has these very rows, so that one half of a trial can be trusted.
  [[nodiscard]] Result<void> Confirm(std::size_t trial, const std::string& rows) const;
  /// Appends a finished trial that is not there yet.
  [[nodiscard]] Result<void> Add(std::size_t trial, const std::string& rows);
  /// Rewrites the file in canonical order, at once or not at all.
  [[nodiscard]] Result<void> Finish();

 private:
  StudyLog(std::string path, const StudyPlan& plan, StudyTable table);
  [[nodiscard]] Error Fault(const char* what) const;
  [[nodiscard]] Result<void> Write(std::string_view text);

  std::string path_;
  StudyFile file_;
  std::size_t lines_ = 0;  // on the disk
  int descriptor_ = -1;
  bool created_ = false;
};

}  // namespace gaitsmith::shell
