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
  bool snap = false;      // to round angles and lengths
  int rod = 0;            // the selected rod, index in Figure::rods
  int endpoint = kNone;   // the dragged endpoint, index in the skeleton
  int turning = kNone;    // the limb whose rod is dragged, index in the skeleton
  float grip_rad = 0.0f;  // angle from the dragged rod to the grabbed point
  bool blank = false;     // nothing is drawn yet: the first stroke is the first rod
  // The view stays while the figure fits into it, so that nothing moves under the pen.
  int still = kNone;          // the endpoint that stays in place during a drag; none: endpoint 0
  ImVec2 anchor{0.0f, 0.0f};  // its place on the board [points]
  float scale = 0.0f;         // [points per metre]; 0: fit the figure into the board
  ImVec2 size{0.0f, 0.0f};    // of the board that the view was fitted into

  static constexpr int kNone = -1;
};

/// The name of figures drawn by hand.
inline constexpr const char* kOwnFigure = "My figure";

/// Height of the board on a panel.
inline constexpr float kBoardHeight = 268.0f;

void DrawDrawingBoard(Ui&, Session&, DrawingBoardState&, const ImRect&);

}  // namespace gaitsmith::shell
