// SPDX-License-Identifier: MIT
// The editor of one rule: its target pose, its time constant, the senses it uses and their intervals. Every
// change is simulated immediately.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct RuleEditorState {
  int rule = -1;        // the open rule; -1: none
  bool reveal = false;  // just opened: scroll it into view
  // The view is fixed while a limb is dragged, so that the limb stays under the pointer.
  int limb = -1;              // index in the skeleton; -1: none
  float grip_rad = 0.0f;      // angle from the limb to the grabbed point
  float scale = 0.0f;         // [points per metre]
  ImVec2 origin{0.0f, 0.0f};  // canvas position of endpoint 0
};

/// @param controller a copy of the shown controller, since edits replace the original. It has rules, and
/// state.rule is one of them
void DrawRuleEditor(Ui&, Session&, const Controller& controller, RuleEditorState&);

}  // namespace gaitsmith::shell
