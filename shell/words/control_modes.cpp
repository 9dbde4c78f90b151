// SPDX-License-Identifier: MIT
#include "shell/words/control_modes.h"

#include <algorithm>

namespace gaitsmith::shell {

namespace {

const ControlModeRow& RowOf(ControlMode mode) { return kControlModes[static_cast<std::size_t>(mode)]; }

}  // namespace

bool CanMove(const ControlModeRow& mode, const Figure& figure) {
  return !figure.HasSprings() || mode.kind != ControllerKind::kNetwork;
}

const ControlModeRow& ControlModeOf(ControllerKind kind, SenseKind senses) {
  for (const ControlModeRow& row : kControlModes) {
    if (row.kind == kind && row.senses == senses) return row;
  }
  return *std::ranges::find(kControlModes, kind, &ControlModeRow::kind);
}

const ControlModeRow& ControlModeOf(const Controller& controller) {
  return ControlModeOf(controller.kind, controller.senses.kind);
}

const ControlModeRow& ControlModeOf(const Document& d) { return ControlModeOf(d.kind, d.senses.kind); }

void SetControlMode(Document& d, const ControlModeRow& mode) {
  d.kind = mode.kind;
  d.senses.kind = mode.senses;
}

const ControlModeRow& ContrastTo(const Controller& controller) {
  return RowOf(controller.senses.kind == SenseKind::kTimer ? ControlMode::kSenses : ControlMode::kTimer);
}

}  // namespace gaitsmith::shell
