// SPDX-License-Identifier: MIT
// Drawing a figure on the empty stage: the board, its tools, and the button that teaches the figure to move.
#pragma once

#include "shell/panels/figure/figure_panel.h"

namespace gaitsmith::shell {

/// Whether a person draws in place of the stage. Ends when the figure moves, or another is opened.
[[nodiscard]] bool DrawsOnStage(const Session&, const FigurePanelState&);

void DrawDrawingStage(Ui&, Session&, FigurePanelState&, const ImRect& stage);

}  // namespace gaitsmith::shell
