// SPDX-License-Identifier: MIT
// gaitsmith new: the document with which the page begins for a figure.
#include "core/document/goals.h"
#include "core/document/json.h"
#include "core/document/standing.h"
#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"

namespace gaitsmith::shell {

Outcome NewCommand(Words words) {
  static constexpr std::string_view kOptions[] = {"figure", "goal", "out"};
  const auto arguments = Arguments::Parse(words, kOptions);
  if (!arguments) return std::unexpected(arguments.error());
  if (!arguments->Positional().empty())
    return Fail(ErrorCode::kUnknownName, "DOC", "is not expected: choose a figure with --figure F");
  const auto figure = ReadFigure(arguments->Last("figure", "ostrich"));
  if (!figure) return std::unexpected(figure.error());
  const auto goal = IndexOf(kGoalNames, arguments->Last("goal", kGoalNames[0]), "--goal");
  if (!goal) return std::unexpected(goal.error());
  Document document = Standing(*figure);
  SetGoal(static_cast<Goal>(*goal), document);
  return WriteText(arguments->Last("out", "-"), EncodeJson(document));
}

}  // namespace gaitsmith::shell
