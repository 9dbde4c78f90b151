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

/// Begins a figure of a person's own: with a blank board on the stage, or with one rod on the panel's board.
void DrawOwnFigure(Session&, FigurePanelState&, bool on_stage);

void DrawFigurePanel(Ui&, Session&, FigurePanelState&);

}  // namespace gaitsmith::shell
