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
};

/// Replaces the figure by one rod, to which a person adds others on the drawing board.
void DrawOwnFigure(Session&, FigurePanelState&);

void DrawFigurePanel(Ui&, Session&, FigurePanelState&);

}  // namespace gaitsmith::shell
