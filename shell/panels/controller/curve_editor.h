// SPDX-License-Identifier: MIT
// The view of a trajectory: the curves of all joints over its period, and the chosen knot, whose pose and
// angles can be changed. Every change is simulated immediately.
#pragma once

#include "shell/session/session.h"
#include "shell/stage/pose_board.h"

namespace gaitsmith::shell {

struct CurveEditorState {
  int knot = 0;
  int joint = 0;  // whose curve is drawn with its knots
  bool dragging = false;
  LimbDrag drag{};
};

/// @param controller a copy of the shown controller, since edits replace the original. It is a trajectory
void DrawCurveEditor(Ui&, Session&, const Controller& controller, CurveEditorState&);

}  // namespace gaitsmith::shell
