// SPDX-License-Identifier: MIT
// gaitsmith merge: joins the shards of a study into one file, or says how far they are.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"
#include "shell/study/study_file.h"
#include "shell/study/study_progress.h"

namespace gaitsmith::shell {

namespace {

Result<StudyFile> ReadStudyFile(const std::string& path) {
  const auto text = ReadText(path);
  if (!text) return std::unexpected(text.error());
  return StudyFile::Parse(*text, path, Ending::kWhole);
}

Result<void> CheckSameTable(const StudyFile& first, const std::string& first_path, const StudyFile& other,
                            const std::string& path) {
  if (first.plan.fingerprint != other.plan.fingerprint) {
    return Fail(ErrorCode::kStructure, path,
                "is of another study, " + other.plan.fingerprint + "; " + first_path + " is of " +
                    first.plan.fingerprint);
  }
  if (first.table != other.table) {
    return Fail(ErrorCode::kStructure, path,
                "holds " + std::string(NameOf(other.table)) + ", but " + first_path + " holds " +
                    std::string(NameOf(first.table)) + "; merge each kind by itself");
  }
  if (Heading(first.plan, first.table) != Heading(other.plan, other.table)) {
    return Fail(ErrorCode::kStructure, path + ":1",
                "its heading is damaged: it differs from that of " + first_path);
  }
  return {};
}

struct Merged {
  StudyFile file;
  StudyProgress progress;
};

Result<Merged> MergeFiles(const std::vector<std::string>& paths) {
  auto merged = ReadStudyFile(paths[0]);
  if (!merged) return std::unexpected(merged.error());
  StudyProgress progress(merged->plan);
  progress.Add(paths[0], *merged);
  std::map<std::size_t, const std::string*> sources;  // file of each trial, for error messages
  for (const auto& [index, rows] : merged->trials) sources[index] = &paths[0];
  for (std::size_t i = 1; i < paths.size(); ++i) {
    auto file = ReadStudyFile(paths[i]);
    if (!file) return std::unexpected(file.error());
    if (auto same = CheckSameTable(*merged, paths[0], *file, paths[i]); !same) {
      return std::unexpected(same.error());
    }
    progress.Add(paths[i], *file);
    for (auto& [index, rows] : file->trials) {
      const auto there = merged->trials.find(index);
      if (there == merged->trials.end()) {
        merged->trials[index] = std::move(rows);
        sources[index] = &paths[i];
      } else if (there->second.text != rows.text) {
        return Fail(
            ErrorCode::kStructure, paths[i] + ":" + std::to_string(rows.line),
            "disagrees about a trial with " + *sources[index] + ":" + std::to_string(there->second.line));
      }
    }
  }
  merged->shard = {};
  return Merged{.file = std::move(*merged), .progress = std::move(progress)};
}

/// Whether a file has just been created, so that its heading may follow at any moment.
bool BeforeHeading(std::string_view text) {
  constexpr std::string_view kStart = "# gaitsmith study ";
  const bool begins = text.starts_with(kStart) || kStart.starts_with(text);
  return begins && std::ranges::count(text, '\n') < 2;
}

/// Reads files that may still be written, one at a time.
Result<StudyProgress> ProgressOf(const std::vector<std::string>& paths) {
  std::optional<StudyFile> first;  // its trials are left out
  std::string first_path;
  std::optional<StudyProgress> progress;
  std::vector<std::string> without_heading;
  for (const std::string& path : paths) {
    const auto text = ReadText(path);
    if (!text) return std::unexpected(text.error());
    if (BeforeHeading(*text)) {
      without_heading.push_back(path);
      continue;
    }
    auto file = StudyFile::Parse(*text, path, Ending::kTorn);
    if (!file) return std::unexpected(file.error());
    if (!progress) {
      progress.emplace(file->plan);
      first = StudyFile{.plan = file->plan, .table = file->table};
      first_path = path;
    }
    if (auto same = CheckSameTable(*first, first_path, *file, path); !same) {
      return std::unexpected(same.error());
    }
    progress->Add(path, *file);
  }
  if (!progress)
    return Fail(ErrorCode::kMissing, paths[0], "has no heading yet, and neither has any other file");
  for (const std::string& path : without_heading) progress->AddWithoutHeading(path);
  return std::move(*progress);
}

Outcome ShowProgress(const Arguments& arguments) {
  if (arguments.Has("out") || arguments.Has("complete")) {
    return WrongCall({ErrorCode::kStructure, "--progress", "goes with no other option; it writes no file"});
  }
  const auto progress = ProgressOf(arguments.Positional());
  if (!progress) return std::unexpected(progress.error());
  if (auto written = WriteText("-", progress->Csv()); !written) return std::unexpected(written.error());
  if (progress->Missing() == 0) return {};
  return std::unexpected(Refusal({ErrorCode::kMissing, "", progress->Sentence()}));
}

/// Guards against a shard given as --out by mistake: overwriting it must not lose trials.
Result<void> CheckNothingLost(const std::string& out, const StudyFile& merged) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(out, ignored)) return {};
  const auto text = ReadText(out);
  if (!text) return std::unexpected(text.error());
  const auto there = StudyFile::Parse(*text, out, Ending::kTorn);
  if (!there) return {};
  for (const auto& [index, rows] : there->trials) {
    if (there->plan.fingerprint == merged.plan.fingerprint && there->table == merged.table &&
        merged.trials.contains(index)) {
      continue;
    }
    return Fail(ErrorCode::kStructure, "--out " + out,
                "holds trials that are not in the files given; name it among them too, or another one");
  }
  return {};
}

}  // namespace

Outcome MergeCommand(Words words) {
  static constexpr std::string_view kOptions[] = {"out"};
  static constexpr std::string_view kFlags[] = {"complete", "progress"};
  const auto arguments = Arguments::Parse(words, kOptions, kFlags);
  if (!arguments) return WrongCall(arguments.error());
  const std::string out = arguments->Last("out");
  if (out.empty() && !arguments->Has("progress")) {
    return WrongCall({ErrorCode::kMissing, "--out", "say where to write the whole (- for standard output)"});
  }
  if (arguments->Positional().empty()) {
    return WrongCall({ErrorCode::kMissing, "SHARD.csv", "give the files to be merged"});
  }
  if (arguments->Has("progress")) return ShowProgress(*arguments);
  const auto merged = MergeFiles(arguments->Positional());
  if (!merged) return std::unexpected(merged.error());
  const auto& [file, progress] = *merged;
  const bool whole = progress.Missing() == 0;
  if (!whole && arguments->Has("complete")) {
    return Fail(ErrorCode::kMissing, "--complete", progress.Sentence());
  }
  if (auto kept = CheckNothingLost(out, file); !kept) return std::unexpected(kept.error());
  if (auto written = WriteText(out, file.Text()); !written) return std::unexpected(written.error());
  if (!whole) std::fprintf(stderr, "gaitsmith merge: %s\n", progress.Sentence().c_str());
  return {};
}

}  // namespace gaitsmith::shell
