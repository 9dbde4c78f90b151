// SPDX-License-Identifier: MIT
#include "shell/command_line/study/study_log.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "shell/command_line/files.h"

namespace gaitsmith::shell {

StudyLog::StudyLog(std::string path, const StudyPlan& plan, StudyTable table, const Shard& shard)
    : path_(std::move(path)), file_{.plan = plan, .table = table, .shard = shard} {}

StudyLog::StudyLog(StudyLog&& other) noexcept
    : path_(std::move(other.path_)),
      file_(std::move(other.file_)),
      lines_(other.lines_),
      descriptor_(std::exchange(other.descriptor_, -1)),
      created_(std::exchange(other.created_, false)) {}

StudyLog::~StudyLog() {
  if (created_) ::unlink(path_.c_str());
  if (descriptor_ >= 0) ::close(descriptor_);
}

Error StudyLog::Fault(const char* what) const {
  return {ErrorCode::kMissing, path_, std::string(what) + ": " + std::strerror(errno)};
}

Result<StudyLog> StudyLog::Open(const std::string& path, const StudyPlan& plan, StudyTable table,
                                const Shard& shard) {
  StudyLog log(path, plan, table, shard);
  struct stat there{};
  const bool exists = ::stat(path.c_str(), &there) == 0;
  if (exists && !S_ISREG(there.st_mode)) {
    return Fail(ErrorCode::kStructure, path, "must be a file of its own, for finished trials are kept there");
  }
  log.descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (log.descriptor_ < 0) return std::unexpected(log.Fault("cannot be written"));
  // Some network file systems do not support locks. On these, continue without one.
  if (::flock(log.descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    return Fail(ErrorCode::kStructure, path, "is being written by another run; give each a file of its own");
  }
  // Another run may have renamed its finished file over the one just opened.
  struct stat opened{};
  if (::stat(path.c_str(), &there) != 0 || ::fstat(log.descriptor_, &opened) != 0 ||
      there.st_ino != opened.st_ino || there.st_dev != opened.st_dev) {
    return Fail(ErrorCode::kStructure, path, "was replaced by another run just now; try again");
  }

  const auto text = ReadText(path);
  if (!text) return std::unexpected(text.error());
  log.created_ = !exists && text->empty();
  const std::string heading = Heading(plan, table, shard);
  if (heading.starts_with(*text)) return log;  // the writer was killed before the heading was complete
  const auto found = ParseHeading(*text);
  if (!found) return Fail(found.error().code, path + ":1", found.error().what);
  if (found->plan.fingerprint != plan.fingerprint) {
    return Fail(ErrorCode::kStructure, path,
                "is of another study, " + found->plan.fingerprint + "; this one is " + plan.fingerprint);
  }
  if (found->shard.of > 1 && found->shard != shard) {
    return Fail(ErrorCode::kStructure, path,
                "is of shard " + NameOf(found->shard) + "; this run is " +
                    (shard.of > 1 ? "shard " + NameOf(shard) : "the whole study"));
  }
  if (!text->starts_with(Heading(plan, table, found->shard))) {
    return Fail(ErrorCode::kStructure, path,
                "holds the other table of this study, or its heading is damaged");
  }
  auto file = StudyFile::Parse(*text, path, Ending::kTorn);
  if (!file) return std::unexpected(file.error());
  log.file_ = std::move(*file);
  const std::string_view whole = std::string_view(*text).substr(0, log.file_.whole_bytes);
  log.lines_ = static_cast<std::size_t>(std::ranges::count(whole, '\n'));
  return log;
}

Result<void> StudyLog::Begin() {
  created_ = false;
  if (::ftruncate(descriptor_, static_cast<off_t>(file_.whole_bytes)) != 0) {
    return std::unexpected(Fault("cannot be written"));
  }
  if (lines_ > 0) return {};
  lines_ = 2;
  return Write(Heading(file_.plan, file_.table, file_.shard));
}

Result<void> StudyLog::Confirm(std::size_t trial, const std::string& rows) const {
  const auto there = file_.trials.find(trial);
  if (there == file_.trials.end() || there->second.text == rows) return {};
  return Fail(ErrorCode::kChecksum, path_ + ":" + std::to_string(there->second.line),
              "this trial now finds something else: the file was changed, or another version wrote it");
}

Result<void> StudyLog::Add(std::size_t trial, const std::string& rows) {
  if (Has(trial)) return {};
  file_.trials[trial] = {.text = rows, .line = lines_ + 1};
  lines_ += static_cast<std::size_t>(std::ranges::count(rows, '\n'));
  return Write(rows);
}

Result<void> StudyLog::Finish() {
  const auto by_line = [](const auto& one, const auto& other) { return one.second.line < other.second.line; };
  if (std::ranges::is_sorted(file_.trials, by_line)) return {};
  return WriteText(path_, file_.Text());
}

Result<void> StudyLog::Write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return std::unexpected(Fault("cannot be written"));
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

}  // namespace gaitsmith::shell
