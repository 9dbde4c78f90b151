// SPDX-License-Identifier: MIT
// The Figure panel: choose a shipped figure, or draw one.
#pragma once

#include "shell/session.h"
#include "shell/widgets.h"

namespace gaitsmith::shell {

/// What the figure's drawing board remembers between frames.
struct FigurePanelState {
  int tool = 0;  // 0 move, 1 grow a rod
  int rod = -1;  // the selected one, as Figure::rods counts; -1 for none
  bool gallery_open = false;
  int endpoint = -1;  // the one being dragged, as the skeleton counts; -1 for none
  // While an endpoint is dragged the picture must not run away under the pointer: another endpoint stays
  // where it is.
  float scale = 0.0f;         // [points per metre]
  ImVec2 anchor{0.0f, 0.0f};  // canvas position of the endpoint that stays
};

void DrawFigurePanel(Ui&, Session&, FigurePanelState&);

}  // namespace gaitsmith::shell
