// SPDX-License-Identifier: MIT
// gaitsmith new: the document with which the page begins for a figure.
#include "core/document/json.h"
#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"
#include "shell/workspace/shipped_documents.h"

namespace gaitsmith::shell {

Outcome NewCommand(Words words) {
  static constexpr std::string_view kOptions[] = {"figure", "out"};
  const auto arguments = Arguments::Parse(words, kOptions);
  if (!arguments) return std::unexpected(arguments.error());
  if (!arguments->Positional().empty())
    return Fail(ErrorCode::kUnknownName, "DOC", "is not an option: say --figure F");
  if (!arguments->Has("figure"))
    return WriteText(arguments->Last("out", "-"), EncodeJson(ShippedDocuments().FirstFigure()));
  const auto figure = ReadFigure(arguments->Last("figure"));
  if (!figure) return std::unexpected(figure.error());
  return WriteText(arguments->Last("out", "-"), EncodeJson(Standing(*figure)));
}

}  // namespace gaitsmith::shell
