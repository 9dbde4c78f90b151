// SPDX-License-Identifier: MIT
// The board for drawing a figure: drag endpoints and rods, and add rods.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

enum class DrawingTool { kMove, kGrow };

/// The board's state between frames.
struct DrawingBoardState {
  DrawingTool tool = DrawingTool::kMove;
  bool snap = false;     // to round angles and lengths
  int rod = 0;           // the selected rod, index in Figure::rods
  int endpoint = kNone;  // the dragged endpoint, index in the skeleton
  int turning = kNone;   // the limb whose rod is dragged, index in the skeleton
  // The view is fixed during a drag: endpoint `still` stays in place.
  int still = kNone;
  float grip_rad = 0.0f;      // angle from the dragged rod to the grabbed point
  float scale = 0.0f;         // [points per metre]
  ImVec2 anchor{0.0f, 0.0f};  // canvas position of endpoint `still`

  static constexpr int kNone = -1;
};

/// The name of figures drawn by hand.
inline constexpr const char* kOwnFigure = "My figure";

void DrawDrawingBoard(Ui&, Session&, DrawingBoardState&);

}  // namespace gaitsmith::shell
