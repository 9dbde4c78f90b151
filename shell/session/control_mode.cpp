// SPDX-License-Identifier: MIT
#include "shell/session/control_mode.h"

namespace gaitsmith::shell {

ControlMode ControlModeOf(const Document& d) {
  if (d.kind == ControllerKind::kNetwork) return ControlMode::kNetwork;
  return d.senses.kind == SenseKind::kTimer ? ControlMode::kTimer : ControlMode::kSenses;
}

void SetControlMode(Document& d, ControlMode mode) {
  d.kind = mode == ControlMode::kNetwork ? ControllerKind::kNetwork : ControllerKind::kRules;
  d.senses.kind = mode == ControlMode::kTimer ? SenseKind::kTimer : SenseKind::kPhysical;
}

ControlMode ContrastTo(const Controller& controller) {
  const bool timer = controller.kind == ControllerKind::kRules && controller.senses.kind == SenseKind::kTimer;
  return timer ? ControlMode::kSenses : ControlMode::kTimer;
}

}  // namespace gaitsmith::shell
