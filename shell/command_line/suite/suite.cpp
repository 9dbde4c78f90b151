// SPDX-License-Identifier: MIT
// gaitsmith suite: searches for a controller for every combination of senses, task and style, and stores each
// with its motion.
#include "shell/command_line/suite/suite_options.h"
#include "shell/command_line/suite/suite_report.h"
#include "shell/command_line/trial_crew.h"
#include "shell/search/parallel_search.h"

namespace gaitsmith::shell {

namespace {

/// Reports on a finished suite. Other options are refused.
Outcome Report(const Arguments& arguments, std::size_t words) {
  if (arguments.Has("list")) {
    if (words <= 2) return ListSuite(arguments.Last("list"));
    return WrongCall({ErrorCode::kStructure, "--list", "goes with no other option"});
  }
  for (const char* option : {"problem", "figure", "search", "out", "shard", "seeds", "joints", "ground"}) {
    if (!arguments.Has(option)) continue;
    return WrongCall({ErrorCode::kStructure, "--extract", "goes with --best and --out-dir alone"});
  }
  if (!arguments.Has("out-dir")) {
    return WrongCall({ErrorCode::kMissing, "--out-dir", "say in which folder to put the documents"});
  }
  return ExtractSuite(arguments.Last("extract"), arguments.Last("out-dir"),
                      arguments.Has("best") ? Extracted::kBest : Extracted::kAll);
}

}  // namespace

Outcome SuiteCommand(Words words) {
  static constexpr std::string_view kOptions[] = {
      "problem",    "figure",      "sense",    "task",       "style",  "search", "seeds",
      "first-seed", "evaluations", "duration", "controller", "rules",  "out",    "shard",
      "threads",    "list",        "extract",  "out-dir",    "joints", "ground"};
  static constexpr std::string_view kFlags[] = {"best"};
  const auto arguments = Arguments::Parse(words, kOptions, kFlags);
  if (!arguments) return WrongCall(arguments.error());
  if (!arguments->Positional().empty()) {
    return WrongCall({ErrorCode::kSyntax, arguments->Positional()[0], "does not belong here"});
  }
  if (arguments->Has("list") || arguments->Has("extract")) return Report(*arguments, words.size());
  for (const char* option : {"best", "out-dir"}) {
    if (!arguments->Has(option)) continue;
    return WrongCall({ErrorCode::kStructure, std::string("--") + option, "goes with --extract alone"});
  }
  const std::string out = arguments->Last("out");
  if (out.empty() || out == "-") {
    return WrongCall({ErrorCode::kMissing, "--out",
                      out.empty() ? "say which file keeps the rows"
                                  : "must be a file, for finished trials are kept there"});
  }
  const auto shard = ReadShard(*arguments);
  if (!shard) return WrongCall(shard.error());
  const auto threads = arguments->Integer("threads", 1, 256, Cores());
  if (!threads) return WrongCall(threads.error());
  const auto study = ReadSuite(*arguments);
  if (!study) return std::unexpected(study.error());
  const StudyOutput outputs[] = {{out, StudyTable::kMotions}};
  if (auto run = RunTrials(*study, outputs, *shard, static_cast<int>(*threads)); !run) {
    return std::unexpected(run.error());
  }
  return {};
}

}  // namespace gaitsmith::shell
