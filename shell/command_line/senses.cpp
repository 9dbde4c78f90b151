// SPDX-License-Identifier: MIT
// gaitsmith senses: what a clip's controller sensed and decided, one row per step.
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "core/control/controllers.h"
#include "core/rollout/decisions.h"
#include "core/rollout/models.h"
#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"
#include "shell/export/exporters.h"

namespace gaitsmith::shell {

namespace {

/// The names of what a controller reads, in the order of the exported controller.
std::vector<std::string> NamesOf(const Controller& controller, const PortCount& ports) {
  std::vector<std::string> names;
  if (controller.kind == ControllerKind::kRules) {
    for (int i = 0; i < SenseCount(controller.senses.kind, ports); ++i)
      names.push_back(SenseName(controller.senses.kind, ports, i));
  }
  if (controller.kind == ControllerKind::kNetwork) {
    const NetworkShape shape = controller.Shape(ports).Network();
    for (int i = 0; i < shape.touches + shape.joints; ++i) names.push_back(InputName(shape, i));
  }
  for (std::string& name : names) std::ranges::replace(name, ' ', '_');
  return names;
}

void Append(std::string& csv, float value) {
  char text[40];
  std::snprintf(text, sizeof text, ",%.9g", static_cast<double>(value));
  csv += text;
}

std::string SensesCsv(const Document& document, std::size_t clip) {
  const auto index = static_cast<std::size_t>(document.timeline[clip].controller);
  const Controller& controller = document.controllers[index];
  const PortCount ports = CountPorts(document.model, document.figure);
  std::string csv = "step,clip,rule";
  for (const std::string& name : NamesOf(controller, ports)) csv += "," + name;
  for (const std::string_view column : {"target", "inverse_tau", "decay"}) {
    for (int joint = 1; joint <= ports.actuators; ++joint)
      csv.append(",").append(column).append("_").append(std::to_string(joint));
  }
  csv += "\n";
  // As in the table of gaitsmith simulate.
  const int first = controller.kind == ControllerKind::kNetwork ? 0 : 1;
  for (const Decision& decision : RecordDecisions(ScriptOf(document), clip)) {
    csv += std::to_string(decision.step) + "," + std::to_string(clip + 1) + "," +
           std::to_string(decision.rule + first);
    for (const auto& numbers : {decision.senses, decision.targets, decision.inverse_tau, decision.decay}) {
      for (const float number : numbers) Append(csv, number);
    }
    csv += "\n";
  }
  return csv;
}

}  // namespace

Outcome SensesCommand(Words words) {
  static constexpr std::array<std::string_view, 3> kOptions = {"clip", "controller", "out"};
  const auto arguments = Arguments::Parse(words, kOptions);
  if (!arguments) return std::unexpected(arguments.error());
  const auto document = TheDocument(*arguments);
  if (!document) return std::unexpected(document.error());
  const auto checked = HasController(*document);
  if (!checked) return std::unexpected(checked.error());
  const auto number = arguments->Integer("clip", 1, static_cast<long long>(document->timeline.size()), 1);
  if (!number) return std::unexpected(number.error());
  const auto clip = static_cast<std::size_t>(*number - 1);
  if (arguments->Has("controller")) {
    const auto done = WriteText(arguments->Last("controller"), ControllerJson(*document, clip));
    if (!done) return std::unexpected(done.error());
  }
  return WriteText(arguments->Last("out", "-"), SensesCsv(*document, clip));
}

}  // namespace gaitsmith::shell
