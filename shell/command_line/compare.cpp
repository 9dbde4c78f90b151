// SPDX-License-Identifier: MIT
// gaitsmith compare: runs searches on problems, each with many seeds, and writes the result and the progress
// of every trial (Figure 6 of the paper).
#include <filesystem>

#include "shell/command_line/study/study_options.h"
#include "shell/command_line/study/summary.h"
#include "shell/command_line/trial_crew.h"
#include "shell/command_line/warnings.h"
#include "shell/search/parallel_search.h"

namespace gaitsmith::shell {

namespace {

/// Both outputs must be files. Neither may be the other, or the temporary file that the other is renamed
/// from.
Result<void> CheckPaths(const std::string& out, const std::string& curves) {
  const auto canonical = [](const std::string& path) {
    std::error_code fault;
    const auto found = std::filesystem::weakly_canonical(path, fault);
    return fault ? path : found.string();
  };
  if (out == "-" || curves == "-") {
    return Fail(ErrorCode::kStructure, out == "-" ? "--out" : "--curves",
                "must be a file, for finished trials are kept there");
  }
  std::error_code ignored;
  const std::string one = canonical(out), other = canonical(curves);
  if (one != other && one + ".part" != other && other + ".part" != one &&
      !std::filesystem::equivalent(out, curves, ignored)) {
    return {};
  }
  return Fail(ErrorCode::kStructure, "--curves", "must be another file than --out");
}

}  // namespace

Outcome CompareCommand(Words words) {
  static constexpr std::string_view kOptions[] = {
      "problem", "search", "trials",   "first-seed", "evaluations", "points", "controller",
      "sense",   "weight", "duration", "shard",      "threads",     "out",    "curves",
      "summary", "way",    "pose",     "joints",     "ground",      "ranks",  "ioh"};
  const auto arguments = Arguments::ParseOptions(words, kOptions);
  if (!arguments) return WrongCall(arguments.error());
  if (arguments->Has("summary")) {
    const auto other = [&](std::string_view option) {
      return option != "summary" && option != "search" && option != "ranks" && option != "ioh" &&
             arguments->Has(option);
    };
    if (std::ranges::any_of(kOptions, other))
      return WrongCall(
          {ErrorCode::kStructure, "--summary", "goes with no other option but --search, --ranks and --ioh"});
    const SummaryRequest request{.paths = arguments->All("summary"),
                                 .searches = arguments->All("search"),
                                 .ranks = arguments->Last("ranks"),
                                 .ioh = arguments->Last("ioh")};
    if (auto said = Summarize(request); !said) return std::unexpected(said.error());
    return {};
  }
  for (const char* option : {"ranks", "ioh"}) {
    if (arguments->Has(option))
      return WrongCall({ErrorCode::kStructure, std::string("--") + option, "goes with --summary"});
  }
  for (const char* option : {"out", "curves"}) {
    if (arguments->Last(option).empty()) {
      return WrongCall({ErrorCode::kMissing, std::string("--") + option, "say which file keeps the rows"});
    }
  }
  const std::string out = arguments->Last("out"), curves_path = arguments->Last("curves");
  if (auto fine = CheckPaths(out, curves_path); !fine) return WrongCall(fine.error());
  const auto shard = ReadShard(*arguments);
  if (!shard) return WrongCall(shard.error());
  const auto threads = arguments->Integer("threads", 1, 256, Cores());
  if (!threads) return WrongCall(threads.error());
  const auto study = ReadStudy(*arguments);
  if (!study) return std::unexpected(study.error());
  for (std::size_t i = 0; i < study->problems.size(); ++i)
    WarnOfMasses(study->plan.problems[i], study->problems[i]);
  const StudyOutput outputs[] = {{out, StudyTable::kResults}, {curves_path, StudyTable::kCurves}};
  if (auto run = RunTrials(*study, outputs, *shard, static_cast<int>(*threads)); !run) {
    return std::unexpected(run.error());
  }
  return {};
}

}  // namespace gaitsmith::shell
