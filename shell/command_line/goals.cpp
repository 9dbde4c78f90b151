// SPDX-License-Identifier: MIT
// gaitsmith goals: searches for every goal with every figure, and counts the seeds that meet each.
#include "core/document/goals.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include "core/document/json.h"
#include "core/document/link.h"
#include "core/document/standing.h"
#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"
#include "shell/command_line/study/study_options.h"
#include "shell/command_line/trial_crew.h"
#include "shell/embedded/embedded.h"
#include "shell/search/parallel_search.h"

namespace gaitsmith::shell {
namespace {

std::vector<std::string> FigureNames(const Arguments& arguments) {
  std::vector<std::string> names = arguments.All("figure");
  if (names.empty()) {
    for (const Example& example : ExampleFigures()) names.emplace_back(example.name);
  }
  return names;
}

std::string Text(float strength) {
  char text[24];
  std::snprintf(text, sizeof text, "%g", static_cast<double>(strength));
  return text;
}

/// The strengths to search with: those given, or the figure's own.
Result<std::vector<float>> ReadStrengths(const Arguments& arguments, Goal goal, const Figure& figure) {
  std::vector<float> strengths;
  for (const std::string& text : arguments.All("strength")) {
    const auto strength = ParseNumber(text, "--strength");
    if (!strength) return std::unexpected(strength.error());
    const auto value = static_cast<float>(*strength);
    if (!(value > 0.0f && value <= kGoalStrengths.back()))
      return Fail(ErrorCode::kOutOfRange, "--strength",
                  "must be above 0, at most " + Text(kGoalStrengths.back()));
    strengths.push_back(value);
  }
  if (strengths.empty()) strengths.push_back(StrengthOf(goal, figure.name));
  return strengths;
}

/// A problem for each figure, goal and strength, with the label FIGURE.GOAL.STRENGTH.
Result<void> AddGoals(const Arguments& arguments, Study& study) {
  std::vector<std::string> goals = arguments.All("goal");
  if (goals.empty()) goals.assign(kGoalNames.begin(), kGoalNames.end());
  for (const std::string& name : FigureNames(arguments)) {
    const auto figure = ReadFigure(name);
    if (!figure) return std::unexpected(figure.error());
    for (const std::string& word : goals) {
      const auto goal = IndexOf(kGoalNames, word, "--goal");
      if (!goal) return std::unexpected(goal.error());
      const auto strengths = ReadStrengths(arguments, static_cast<Goal>(*goal), *figure);
      if (!strengths) return std::unexpected(strengths.error());
      for (const float strength : *strengths) {
        const std::string label =
            std::filesystem::path(name).stem().string() + "." + word + "." + Text(strength);
        Document document = Standing(*figure);
        document.title = label;
        SetGoal(static_cast<Goal>(*goal), strength, document);
        if (auto added = AddProblem(label, OnlyProblem(document), "--goal", study); !added) return added;
        study.problems.back().figure.name = figure->name;
      }
    }
  }
  return {};
}

/// Prints how many motions of each label of a file meet their goal.
Outcome CountThoseThatMeet(const std::string& path) {
  const auto text = ReadText(path);
  if (!text) return std::unexpected(text.error());
  const auto file = StudyFile::Parse(*text, path, Ending::kTorn);
  if (!file) return std::unexpected(file.error());
  if (file->table != StudyTable::kMotions)
    return Fail(ErrorCode::kStructure, path, "holds " + std::string(NameOf(file->table)) + ", not motions");
  struct Count {
    int seeds = 0, met = 0;
  };
  std::map<std::string, Count> counts;
  for (const auto& [index, rows] : file->trials) {
    const std::string& label = file->plan.problems[file->plan.At(index).problem];
    const std::size_t first = label.find('.'), second = label.find('.', first + 1);
    if (first == std::string::npos || second == std::string::npos)
      return Fail(ErrorCode::kSyntax, path, "\"" + label + "\" must be FIGURE.GOAL.STRENGTH");
    const auto goal = IndexOf(kGoalNames, label.substr(first + 1, second - first - 1), path);
    if (!goal) return std::unexpected(goal.error());
    const auto document = DecodeLink(FieldOf(rows.text, kLinkField));
    if (!document) return std::unexpected(document.error());
    const Motion motion = Simulate(*document);
    const float seconds = static_cast<float>(document->duration_steps) * kStep;
    Count& count = counts[label];
    ++count.seeds;
    count.met +=
        Meets(static_cast<Goal>(*goal), document->figure, motion.TermsAt(motion.Frames() - 1), seconds) ? 1
                                                                                                        : 0;
  }
  std::printf("figure,goal,strength,seeds,met\n");
  for (const auto& [label, count] : counts) {
    std::string fields = label;
    const std::size_t first = fields.find('.');
    fields[first] = ',';
    fields[fields.find('.', first)] = ',';
    std::printf("%s,%d,%d\n", fields.c_str(), count.seeds, count.met);
  }
  return {};
}

}  // namespace

Outcome GoalsCommand(Words words) {
  static constexpr std::string_view kOptions[] = {"figure", "search",      "goal",       "strength",
                                                  "seeds",  "evaluations", "first-seed", "out",
                                                  "shard",  "threads",     "summary"};
  const auto arguments = Arguments::ParseOptions(words, kOptions);
  if (!arguments) return WrongCall(arguments.error());
  if (arguments->Has("summary")) {
    if (words.size() > 2) return WrongCall({ErrorCode::kStructure, "--summary", "goes with no other option"});
    return CountThoseThatMeet(arguments->Last("summary"));
  }
  const std::string out = arguments->Last("out");
  if (out.empty() || out == "-")
    return WrongCall({ErrorCode::kMissing, "--out", "say which file keeps the finished searches"});
  const auto shard = ReadShard(*arguments);
  if (!shard) return WrongCall(shard.error());
  const auto threads = arguments->Integer("threads", 1, 256, Cores());
  if (!threads) return WrongCall(threads.error());
  Study study;
  if (auto read = ReadSeeds(*arguments, "seeds", study.plan); !read) return WrongCall(read.error());
  if (auto added = AddSearch(arguments->Last("search"), study); !added) return WrongCall(added.error());
  if (auto added = AddGoals(*arguments, study); !added) return WrongCall(added.error());
  study.plan.fingerprint = FingerprintOf(study);
  const StudyOutput outputs[] = {{out, StudyTable::kMotions}};
  if (auto run = RunTrials(study, outputs, *shard, static_cast<int>(*threads)); !run)
    return std::unexpected(run.error());
  return {};
}

}  // namespace gaitsmith::shell
