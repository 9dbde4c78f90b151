// SPDX-License-Identifier: MIT
// A study's file on disk while its trials run. Each trial is appended as it finishes, so killing the program
// loses only unfinished trials, and the same command resumes the study.
#pragma once

#include "shell/study/study_file.h"

namespace gaitsmith::shell {

class StudyLog {
 public:
  /// Opens or creates the file, locks it for this process, and reads its trials. Writes nothing yet.
  /// Refuses a file that is not of this study, names another shard, has a damaged row, or is being written by
  /// another process. A file that names no shard may hold any.
  [[nodiscard]] static Result<StudyLog> Open(const std::string& path, const StudyPlan&, StudyTable,
                                             const Shard&);
  StudyLog(StudyLog&&) noexcept;
  StudyLog& operator=(StudyLog&&) = delete;
  /// Deletes a file that Open created if Begin was not called.
  ~StudyLog();

  [[nodiscard]] StudyTable Table() const { return file_.table; }
  [[nodiscard]] bool Has(std::size_t trial) const { return file_.trials.contains(trial); }
  /// Writes the heading of a new file, or truncates an incomplete last row.
  [[nodiscard]] Result<void> Begin();
  /// Checks that rows of the trial already in the file equal `rows`. A trial runs again if any file lacks it.
  [[nodiscard]] Result<void> Confirm(std::size_t trial, const std::string& rows) const;
  /// Appends a finished trial that the file lacks.
  [[nodiscard]] Result<void> Add(std::size_t trial, const std::string& rows);
  /// Rewrites the file in canonical order, atomically.
  [[nodiscard]] Result<void> Finish();

 private:
  StudyLog(std::string path, const StudyPlan& plan, StudyTable table, const Shard& shard);
  [[nodiscard]] Error Fault(const char* what) const;
  [[nodiscard]] Result<void> Write(std::string_view text);

  std::string path_;
  StudyFile file_;
  std::size_t lines_ = 0;  // number of lines on disk
  int descriptor_ = -1;
  bool created_ = false;
};

}  // namespace gaitsmith::shell
