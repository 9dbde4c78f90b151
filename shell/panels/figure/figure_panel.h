// SPDX-License-Identifier: MIT
// The Figure panel: choose a shipped figure, or draw one.
#pragma once

#include "shell/panels/figure/drawing_board.h"
#include "shell/panels/figure/spring_board.h"
#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct FigurePanelState {
  DrawingBoardState board;
  SpringBoardState springs;
  bool gallery_open = false;
  bool on_stage = false;  // the board takes the place of the stage
};

/// Begins a figure of a person's own: with a blank board on the stage, or with one rod or spring on the
/// panel's board.
enum class OwnFigure { kRods, kSprings };
void DrawOwnFigure(Session&, FigurePanelState&, OwnFigure, bool on_stage);

void DrawFigurePanel(Ui&, Session&, FigurePanelState&);

}  // namespace gaitsmith::shell
