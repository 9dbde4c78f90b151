// SPDX-License-Identifier: MIT
// The editor of one rule: its target pose, its time constant, the senses it uses and their intervals. Every
// change is simulated immediately.
#pragma once

#include "shell/session/session.h"
#include "shell/stage/pose_board.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct RuleEditorState {
  int rule = -1;        // the open rule; -1: none
  bool reveal = false;  // just opened: scroll it into view
  LimbDrag drag{};
};

/// @param controller a copy of the shown controller, since edits replace the original. It has rules, and
/// state.rule is one of them
void DrawRuleEditor(Ui&, Session&, const Controller& controller, RuleEditorState&);

}  // namespace gaitsmith::shell
