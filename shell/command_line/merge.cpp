// SPDX-License-Identifier: MIT
// gaitsmith merge: joins the shards of a study into one file.
#include <cstdio>
#include <filesystem>

#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"
#include "shell/study/study_file.h"

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

Result<StudyFile> MergeFiles(const std::vector<std::string>& paths) {
  auto merged = ReadStudyFile(paths[0]);
  if (!merged) return merged;
  std::map<std::size_t, const std::string*> sources;  // file of each trial, for error messages
  for (const auto& [index, rows] : merged->trials) sources[index] = &paths[0];
  for (std::size_t i = 1; i < paths.size(); ++i) {
    auto file = ReadStudyFile(paths[i]);
    if (!file) return file;
    if (auto same = CheckSameTable(*merged, paths[0], *file, paths[i]); !same) {
      return std::unexpected(same.error());
    }
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
  return merged;
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
  static constexpr std::string_view kFlags[] = {"complete"};
  const auto arguments = Arguments::Parse(words, kOptions, kFlags);
  if (!arguments) return WrongCall(arguments.error());
  const std::string out = arguments->Last("out");
  if (out.empty()) {
    return WrongCall({ErrorCode::kMissing, "--out", "say where to write the whole (- for standard output)"});
  }
  if (arguments->Positional().empty()) {
    return WrongCall({ErrorCode::kMissing, "SHARD.csv", "give the files to be merged"});
  }
  const auto merged = MergeFiles(arguments->Positional());
  if (!merged) return std::unexpected(merged.error());
  const std::size_t missing = merged->plan.Total() - merged->trials.size();
  const std::string sentence =
      std::to_string(missing) + " of " + std::to_string(merged->plan.Total()) + " trials are missing";
  if (missing > 0 && arguments->Has("complete")) return Fail(ErrorCode::kMissing, "--complete", sentence);
  if (auto kept = CheckNothingLost(out, *merged); !kept) return std::unexpected(kept.error());
  if (auto written = WriteText(out, merged->Text()); !written) return std::unexpected(written.error());
  if (missing > 0) std::fprintf(stderr, "gaitsmith merge: %s\n", sentence.c_str());
  return {};
}

}  // namespace gaitsmith::shell
