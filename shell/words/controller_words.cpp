// SPDX-License-Identifier: MIT
#include "shell/words/controller_words.h"

#include "shell/words/control_modes.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

double PeriodS(const SenseSpec& senses) {
  return static_cast<double>(static_cast<float>(senses.period_steps) * kStep);
}

// The pattern to fill with the number of rules or nodes, and the timer's period.
const char* ControllerPattern(ControllerKind kind, const SenseSpec& senses, int rules) {
  const ControlModeRow& mode = ControlModeOf(kind, senses.kind);
  return rules == 1 ? mode.one_unit : mode.many_units;
}

}  // namespace

std::string ControllerWords(ControllerKind kind, const SenseSpec& senses, int rules) {
  return Tr(ControllerPattern(kind, senses, rules), rules, Fixed(PeriodS(senses), 2));
}

std::string ControllerName(ControllerKind kind, const SenseSpec& senses, int rules) {
  return Fill(ControllerPattern(kind, senses, rules), {rules, PlainFixed(PeriodS(senses), 2)});
}

std::string TaskWords(TaskKind kind) { return Tr(TaskName(kind)); }

const char* TaskName(TaskKind kind) {
  switch (kind) {
    case TaskKind::kTravel:
      return TrLater("travel");
    case TaskKind::kTravelRight:
      return TrLater("travel to the right");
    case TaskKind::kTravelLeft:
      return TrLater("travel to the left");
    case TaskKind::kJump:
      return TrLater("jump");
  }
  return "";
}

}  // namespace gaitsmith::shell
