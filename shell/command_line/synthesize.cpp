// SPDX-License-Identifier: MIT
// gaitsmith synthesize: finds a controller and writes it as a document.

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "core/document/json.h"
#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"
#include "shell/command_line/problem_options.h"
#include "shell/command_line/search_options.h"
#include "shell/parallel_search.h"

namespace gaitsmith::shell {

namespace {

/// A bar on standard error, drawn at most ten times a second, and only for a person who watches.
class ProgressBar {
 public:
  void Draw(const SearchProgress& progress) {
    const auto now = std::chrono::steady_clock::now();
    const bool done = progress.state == SearchState::kDone;
    if (!terminal_ || (now - drawn_ < std::chrono::milliseconds(100) && !done)) return;
    drawn_ = now;
    constexpr int kWidth = 28;
    std::string bar(kWidth, ' ');
    const auto filled = std::int64_t{progress.evaluations} * kWidth / progress.budget;
    std::fill_n(bar.begin(), filled, '=');
    std::fprintf(stderr, "\r[%s] %d of %d  %.0f/s  best %.3f  %.0f s left \x1b[K%s", bar.c_str(),
                 progress.evaluations, progress.budget, progress.evaluations_per_second,
                 static_cast<double>(progress.best_fitness), progress.seconds_left, done ? "\n" : "");
  }

 private:
  std::chrono::steady_clock::time_point drawn_;
  bool terminal_ = isatty(STDERR_FILENO) != 0;
};

/// A document's problem with the controller that it begins with, for a search to start from.
Result<Document> ReadStart(const Arguments& arguments) {
  for (const char* option : {"figure", "sense", "rules", "controller"}) {
    if (!arguments.Has(option)) continue;
    return Fail(ErrorCode::kStructure, std::string("--") + option,
                "cannot be given with --from: the controller fits its own");
  }
  auto document = ReadDocument(arguments.Last("from"));
  if (!document) return document;
  if (document->controllers.empty()) {
    return Fail(ErrorCode::kMissing, "--from " + arguments.Last("from"), "has no controller to start from");
  }
  const int first = document->timeline.empty() ? 0 : document->timeline.front().controller;
  Controller start = document->controllers[static_cast<std::size_t>(first)];
  document->senses = start.senses;
  document->rules = start.rules;
  document->kind = start.kind;
  document->controllers = {std::move(start)};
  document->timeline.clear();
  document->search = {};
  document->search.start = 0;
  document->hash.reset();
  return document;
}

/// A document's problem, to be searched from a random controller.
Result<Document> ReadProblem(const Arguments& arguments) {
  for (const char* option : {"figure", "from"}) {
    if (!arguments.Has(option)) continue;
    return Fail(ErrorCode::kStructure, std::string("--") + option, "cannot be given with --problem");
  }
  auto document = ReadDocument(arguments.Last("problem"));
  if (!document) return document;
  document->controllers.clear();
  document->timeline.clear();
  document->search = {};
  document->hash.reset();
  return document;
}

/// A new document about a figure.
Result<Document> ReadNew(const Arguments& arguments) {
  const auto figure = ReadFigure(arguments.Last("figure", "mr-star-man"));
  if (!figure) return std::unexpected(figure.error());
  Document document;
  document.figure = *figure;
  document.title = figure->name;
  return document;
}

/// The document that the options describe, but for the controller to be found.
Result<Document> ReadRequest(const Arguments& arguments) {
  auto read = arguments.Has("problem") ? ReadProblem(arguments)
              : arguments.Has("from")  ? ReadStart(arguments)
                                       : ReadNew(arguments);
  if (!read) return read;
  Document& document = *read;
  if (arguments.Has("task")) {
    const auto task = IndexOf(kTaskNames, arguments.Last("task"), "--task");
    if (!task) return std::unexpected(task.error());
    document.task.kind = static_cast<TaskKind>(*task);
  }
  const auto algorithm = IndexOf(kAlgorithmNames, arguments.Last("search", "sphc"), "--search");
  if (!algorithm) return std::unexpected(algorithm.error());
  document.search.algorithm = static_cast<Algorithm>(*algorithm);
  if (auto set = SetProblemOptions(arguments, document); !set) return std::unexpected(set.error());
  document.duration_steps = document.task.duration_steps;
  const auto rules = arguments.Integer("rules", 1, kMaxRules, document.rules);
  if (!rules) return std::unexpected(rules.error());
  document.rules = static_cast<int>(*rules);
  const auto evaluations = arguments.Integer("evaluations", 1, 100'000'000, document.search.evaluations);
  if (!evaluations) return std::unexpected(evaluations.error());
  document.search.evaluations = static_cast<int>(*evaluations);
  const auto seed = arguments.Integer("seed", 0, 0xffffffffLL, 1);
  if (!seed) return std::unexpected(seed.error());
  document.search.seed = static_cast<std::uint32_t>(*seed);
  for (const std::string& option : arguments.All("search-option")) {
    if (auto set = SetSearchOption(option, document.search); !set) return std::unexpected(set.error());
  }
  if (auto valid = Validate(document); !valid) return std::unexpected(valid.error());
  return document;
}

std::string CurveCsv(const std::vector<Search::CurvePoint>& curve) {
  std::string csv = "evaluation,best\n";
  for (const auto& point : curve) {
    char line[64];
    std::snprintf(line, sizeof line, "%d,%.9g\n", point.evaluation, static_cast<double>(point.best));
    csv += line;
  }
  return csv;
}

}  // namespace

Outcome SynthesizeCommand(Words words) {
  static constexpr std::string_view kOptions[] = {
      "figure", "task",    "sense", "weight",   "search", "evaluations",   "seed",       "out",
      "curve",  "threads", "rules", "duration", "from",   "search-option", "controller", "problem"};
  const auto arguments = Arguments::ParseOptions(words, kOptions);
  if (!arguments) return std::unexpected(arguments.error());
  if (!arguments->Has("out"))
    return Fail(ErrorCode::kMissing, "--out", "say where to write the document (- for standard output)");
  auto document = ReadRequest(*arguments);
  if (!document) return std::unexpected(document.error());
  const auto threads = arguments->Integer("threads", 1, 256, Cores());
  if (!threads) return std::unexpected(threads.error());

  ProgressBar bar;
  SearchControl control;
  const SearchProgress found = RunParallelSearch(
      ProblemOf(*document), document->search, static_cast<int>(*threads), control,
      [&](const SearchProgress& progress) { bar.Draw(progress); }, SpaceOf(*document).start);

  const auto algorithm = kAlgorithmNames[static_cast<std::size_t>(document->search.algorithm)];
  document->controllers.push_back({"found by " + std::string(algorithm), document->kind, document->senses,
                                   document->rules, found.best_genome});
  document->timeline.push_back({static_cast<int>(document->controllers.size()) - 1, 0});
  document->hash = Simulate(*document).Hash();
  if (auto written = WriteText(arguments->Last("out"), EncodeJson(*document)); !written) return written;
  if (arguments->Has("curve")) return WriteText(arguments->Last("curve"), CurveCsv(found.curve));
  return {};
}

}  // namespace gaitsmith::shell
