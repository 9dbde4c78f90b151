// SPDX-License-Identifier: MIT
// gaitsmith simulate: a document's motion as CSV, one row per step.
#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"
#include "shell/command_line/warnings.h"
#include "shell/export/exporters.h"

namespace gaitsmith::shell {

Outcome SimulateCommand(Words words) {
  static constexpr std::string_view kOptions[] = {"csv"};
  const auto arguments = Arguments::Parse(words, kOptions);
  if (!arguments) return std::unexpected(arguments.error());
  const auto document = TheDocument(*arguments);
  if (!document) return std::unexpected(document.error());
  WarnOfMasses(arguments->Positional()[0], *document);
  return WriteText(arguments->Last("csv", "-"), TrajectoryCsv(*document, Simulate(*document)));
}

}  // namespace gaitsmith::shell
