// SPDX-License-Identifier: MIT
// gaitsmith merge: joins the shards of a study into one file, or says how far they are.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>

#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"
#include "shell/study/study_file.h"
#include "shell/study/study_progress.h"
#include "shell/study/switch_file.h"

namespace gaitsmith::shell {

namespace {

/// @tparam File StudyFile or SwitchFile
template <class File>
Result<File> ReadShardFile(const std::string& path) {
  const auto text = ReadText(path);
  if (!text) return std::unexpected(text.error());
  return File::Parse(*text, path, Ending::kWhole);
}

std::unexpected<Error> AnotherStudy(const std::string& path, const std::string& is,
                                    const std::string& first_path, const std::string& first) {
  return Fail(ErrorCode::kStructure, path,
              "is of another study, " + is + "; " + first_path + " is of " + first);
}

Result<void> CheckSameTable(const StudyFile& first, const std::string& first_path, const StudyFile& other,
                            const std::string& path) {
  if (first.plan.fingerprint != other.plan.fingerprint) {
    return AnotherStudy(path, other.plan.fingerprint, first_path, first.plan.fingerprint);
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

Result<void> CheckSameTable(const SwitchFile& first, const std::string& first_path, const SwitchFile& other,
                            const std::string& path) {
  if (first.fingerprint == other.fingerprint && first.labels == other.labels && first.times == other.times)
    return {};
  return AnotherStudy(path, other.fingerprint, first_path, first.fingerprint);
}

StudyProgress EmptyProgress(const StudyFile& file) { return {file.plan.Total(), "trials"}; }
StudyProgress EmptyProgress(const SwitchFile& file) { return {file.Total(), "pairs"}; }

template <class File>
std::string SentenceOf(const StudyProgress& progress, const File& file) {
  return progress.Sentence([&file](std::size_t trial) { return file.NameOfTrial(trial); });
}

template <class File>
struct Merged {
  File file;
  StudyProgress progress;
};

template <class File>
Result<Merged<File>> MergeFiles(const std::vector<std::string>& paths) {
  auto merged = ReadShardFile<File>(paths[0]);
  if (!merged) return std::unexpected(merged.error());
  StudyProgress progress = EmptyProgress(*merged);
  progress.Add(paths[0], merged->shard, merged->trials);
  std::map<std::size_t, const std::string*> sources;  // file of each trial, for error messages
  for (const auto& [index, rows] : merged->trials) sources[index] = &paths[0];
  for (std::size_t i = 1; i < paths.size(); ++i) {
    auto file = ReadShardFile<File>(paths[i]);
    if (!file) return std::unexpected(file.error());
    if (auto same = CheckSameTable(*merged, paths[0], *file, paths[i]); !same) {
      return std::unexpected(same.error());
    }
    progress.Add(paths[i], file->shard, file->trials);
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
  return Merged<File>{.file = std::move(*merged), .progress = std::move(progress)};
}

/// Guards against a shard given as --out by mistake: overwriting it must not lose trials.
template <class File>
Result<void> CheckNothingLost(const std::string& out, const std::string& first_path, const File& merged) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(out, ignored)) return {};
  const auto text = ReadText(out);
  if (!text) return std::unexpected(text.error());
  const auto there = File::Parse(*text, out, Ending::kTorn);
  if (!there) return {};
  const bool same = CheckSameTable(merged, first_path, *there, out).has_value();
  for (const auto& [index, rows] : there->trials) {
    if (same && merged.trials.contains(index)) continue;
    return Fail(ErrorCode::kStructure, "--out " + out,
                "holds trials that are not in the files given; name it among them too, or another one");
  }
  return {};
}

/// Whether a file has just been created, so that its heading may follow at any moment.
bool BeforeHeading(std::string_view text) {
  constexpr std::string_view kStart = "# gaitsmith ";
  const bool begins = text.starts_with(kStart) || kStart.starts_with(text);
  return begins && std::ranges::count(text, '\n') < 2;
}

/// Reads files that may still be written, one at a time, and prints how far they are.
template <class File>
Outcome ShowProgress(const std::vector<std::string>& paths) {
  std::optional<File> first;  // its trials are left out
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
    auto file = File::Parse(*text, path, Ending::kTorn);
    if (!file) return std::unexpected(file.error());
    if (!first) {
      progress = EmptyProgress(*file);
      first = *file;
      first->trials.clear();
      first_path = path;
    }
    if (auto same = CheckSameTable(*first, first_path, *file, path); !same) {
      return std::unexpected(same.error());
    }
    progress->Add(path, file->shard, file->trials);
  }
  if (!progress) {
    return Fail(ErrorCode::kMissing, paths[0], "has no heading yet, and neither has any other file");
  }
  for (const std::string& path : without_heading) progress->AddWithoutHeading(path);
  if (auto written = WriteText("-", progress->Csv()); !written) return std::unexpected(written.error());
  if (progress->Missing() == 0) return {};
  return Fail(ErrorCode::kMissing, "", SentenceOf(*progress, *first));
}

template <class File>
Outcome WriteMerged(const std::vector<std::string>& paths, const std::string& out, bool complete) {
  const auto merged = MergeFiles<File>(paths);
  if (!merged) return std::unexpected(merged.error());
  const auto& [file, progress] = *merged;
  const bool whole = progress.Missing() == 0;
  if (!whole && complete) return Fail(ErrorCode::kMissing, "--complete", SentenceOf(progress, file));
  if (auto kept = CheckNothingLost(out, paths[0], file); !kept) return std::unexpected(kept.error());
  if (auto written = WriteText(out, file.Text()); !written) return std::unexpected(written.error());
  if (!whole) std::fprintf(stderr, "gaitsmith merge: %s\n", SentenceOf(progress, file).c_str());
  return {};
}

/// Looks only at the beginning, which standard input would lose.
bool IsOfSwitches(const std::string& path) {
  if (path == "-") return false;
  std::ifstream file(path, std::ios::binary);
  std::string line;
  return std::getline(file, line) && SwitchFile::Begins(line);
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
  const auto& paths = arguments->Positional();
  const bool switches = IsOfSwitches(paths[0]), complete = arguments->Has("complete");
  if (arguments->Has("progress")) {
    if (complete || !out.empty()) {
      return WrongCall({ErrorCode::kStructure, "--progress", "goes with no other option; it writes no file"});
    }
    return switches ? ShowProgress<SwitchFile>(paths) : ShowProgress<StudyFile>(paths);
  }
  return switches ? WriteMerged<SwitchFile>(paths, out, complete)
                  : WriteMerged<StudyFile>(paths, out, complete);
}

}  // namespace gaitsmith::shell
