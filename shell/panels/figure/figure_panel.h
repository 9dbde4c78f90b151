// SPDX-License-Identifier: MIT
// The Figure panel: choose a shipped figure, or draw one.
#pragma once

#include "shell/panels/figure/drawing_board.h"
#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct FigurePanelState {
  DrawingBoardState board;
  bool gallery_open = false;
  bool on_stage = false;  // the board takes the place of the stage
};

/// Clears the board, on the stage, for a figure that a person draws.
void DrawOwnFigure(Session&, FigurePanelState&);

void DrawFigurePanel(Ui&, Session&, FigurePanelState&);

}  // namespace gaitsmith::shell
