// SPDX-License-Identifier: MIT
// The board on which a figure is drawn: its endpoints and rods are dragged, rods grow from it.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

enum class DrawingTool { kMove, kGrow };

/// What the board remembers between frames.
struct DrawingBoardState {
  DrawingTool tool = DrawingTool::kMove;
  bool snap = false;     // to angles and lengths that are easily said
  int rod = 0;           // the selected one, as Figure::rods counts
  int endpoint = kNone;  // the one being dragged, as the skeleton counts
  int turning = kNone;   // the limb being dragged by its rod, as the skeleton counts
  // While something is dragged the picture must not run away under the pointer: the endpoint `still` stays
  // where it is.
  int still = kNone;
  float grip_rad = 0.0f;      // from the dragged rod's direction to where it is held
  float scale = 0.0f;         // [points per metre]
  ImVec2 anchor{0.0f, 0.0f};  // canvas position of the endpoint that stays

  static constexpr int kNone = -1;
};

/// What is drawn by hand is called.
inline constexpr const char* kOwnFigure = "My figure";

void DrawDrawingBoard(Ui&, Session&, DrawingBoardState&);

}  // namespace gaitsmith::shell
