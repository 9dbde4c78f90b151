// SPDX-License-Identifier: MIT
// One rule under the hand: its target pose to be dragged, its time constant, the senses it heeds and their
// intervals. Every change is simulated at once.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct RuleEditorState {
  int rule = -1;        // the one that is open; -1: none
  bool reveal = false;  // it was opened just now, and should be seen
  // While a limb is dragged the picture must not run away under the pointer.
  int limb = -1;              // as the skeleton counts; -1: none
  float grip_rad = 0.0f;      // from the limb to where it was taken hold of
  float scale = 0.0f;         // [points per metre]
  ImVec2 origin{0.0f, 0.0f};  // canvas position of endpoint 0
};

/// @param controller the session's shown one as this frame began, of rules: a copy, for edits replace the
/// session's
///                   own. state.rule is one of them
void DrawRuleEditor(Ui&, Session&, const Controller& controller, RuleEditorState&);

}  // namespace gaitsmith::shell
