// SPDX-License-Identifier: MIT
#include "shell/command_line/suite/suite_options.h"

#include <algorithm>

#include "shell/command_line/files.h"
#include "shell/command_line/problem_options.h"
#include "shell/command_line/study/study_options.h"

namespace gaitsmith::shell {

namespace {

/// A value of --style, such as "shuffle=slip_sum:usual,max_cm_height:-0.5".
struct Style {
  struct Weight {
    std::string term, value;
  };
  std::string text, name;
  std::vector<Weight> weights;
};

Result<Style> ReadStyle(const std::string& text) {
  const std::string where = "--style " + text;
  const std::size_t equals = text.find('=');
  Style style{.text = text, .name = text.substr(0, equals), .weights = {}};
  // A dot separates the parts of a label, and labels become file names.
  if (!IsLabel(style.name) || style.name.find_first_of("./\\:") != std::string::npos) {
    return Fail(
        ErrorCode::kSyntax, where,
        "\"" + style.name + "\" cannot be a name: it must have no blank, comma, quote, dot, colon or slash");
  }
  if (equals == std::string::npos) return Fail(ErrorCode::kSyntax, where, "must be NAME=TERM:W[,TERM:W]");
  for (std::size_t at = equals + 1; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string part = text.substr(at, end - at);
    const std::size_t colon = part.find(':');
    if (colon == std::string::npos) {
      return Fail(ErrorCode::kSyntax, where, "\"" + part + "\" must be TERM:W");
    }
    style.weights.push_back({part.substr(0, colon), part.substr(colon + 1)});
    at = end + 1;
  }
  return style;
}

Result<std::vector<Style>> ReadStyles(const Arguments& arguments) {
  std::vector<Style> styles;
  for (const std::string& text : arguments.All("style")) {
    auto style = ReadStyle(text);
    if (!style) return std::unexpected(style.error());
    styles.push_back(std::move(*style));
  }
  if (styles.empty()) styles.push_back({.text = "plain", .name = "plain", .weights = {}});
  return styles;
}

/// The settings that all trials share, without a controller.
std::expected<Document, Refusal> ReadCommon(const Arguments& arguments) {
  if (arguments.Has("problem") == arguments.Has("figure")) {
    return WrongCall(
        {arguments.Has("figure") ? ErrorCode::kStructure : ErrorCode::kMissing,
         arguments.Has("figure") ? "--figure" : "--problem",
         arguments.Has("figure") ? "cannot be given with --problem" : "must be given, or --figure"});
  }
  Document common;
  std::string name;
  if (arguments.Has("problem")) {
    auto read = ReadDocument(arguments.Last("problem"));
    if (!read) return std::unexpected(Refusal(read.error()));
    read->search.start = -1;  // a start controller fits at most one of the senses
    name = read->figure.name;
    common = OnlyProblem(*read);
  } else {
    auto figure = ReadFigure(arguments.Last("figure"));
    if (!figure) return std::unexpected(Refusal(figure.error()));
    name = figure->name;
    SetFigure(*figure, common);
  }
  common.figure.name = name;
  common.task.weights = {};  // styles set the weights
  if (auto set = SetProblemOptions(arguments, common); !set) return WrongCall(set.error());
  const auto rules = arguments.Integer("rules", 1, kMaxRules, common.rules);
  if (!rules) return WrongCall(rules.error());
  common.rules = static_cast<int>(*rules);
  return common;
}

/// One figure's problem for each task and style.
Result<void> AddTasks(const Arguments& arguments, const std::vector<Style>& styles, const Document& common,
                      Study& study) {
  std::vector<std::string> tasks = arguments.All("task");
  if (tasks.empty()) tasks = {std::string(kTaskNames[static_cast<std::size_t>(common.task.kind)])};
  for (const std::string& task : tasks) {
    const auto kind = IndexOf(kTaskNames, task, "--task");
    if (!kind) return std::unexpected(kind.error());
    for (const Style& style : styles) {
      Document problem = common;
      problem.task.kind = static_cast<TaskKind>(*kind);
      for (const auto& [term, value] : style.weights) {
        const std::string where = "--style " + style.text;
        if (auto set = SetWeight(term, value, problem, where, where); !set) return set;
      }
      const std::string label = SenseText(common.senses) + "." + task + "." + style.name;
      problem.title = label;
      if (auto added = AddProblem(label, std::move(problem), "trial", study); !added) return added;
    }
  }
  return {};
}

}  // namespace

std::expected<Study, Refusal> ReadSuite(const Arguments& arguments) {
  Study study;
  if (auto read = ReadSeeds(arguments, "seeds", study.plan); !read) return WrongCall(read.error());
  // With two searches, label and seed would not identify a motion.
  if (arguments.All("search").size() > 1) {
    return WrongCall({ErrorCode::kStructure, "--search", "can be given once"});
  }
  if (auto added = AddSearch(arguments.Last("search"), study); !added) return WrongCall(added.error());
  const auto styles = ReadStyles(arguments);
  if (!styles) return WrongCall(styles.error());
  auto common = ReadCommon(arguments);
  if (!common) return std::unexpected(common.error());
  std::vector<std::string> senses = arguments.All("sense");
  if (senses.empty()) senses = {SenseText(common->senses)};
  for (const std::string& sense : senses) {
    if (auto set = SetSense(sense, common->senses); !set) return WrongCall(set.error());
    if (auto added = AddTasks(arguments, *styles, *common, study); !added) return WrongCall(added.error());
  }
  study.plan.fingerprint = FingerprintOf(study);
  return study;
}

}  // namespace gaitsmith::shell
