// SPDX-License-Identifier: MIT
// A figure in its drawn pose as a small picture.
#pragma once

#include "core/physics/figure.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// Draws the figure as large as it fits, standing on the rectangle's lower edge.
/// @param behind the colour that it is drawn on @param turn_rad  of the whole figure, anticlockwise
void DrawFigureThumbnail(Ui&, const Figure&, const ImRect&, ImU32 colour, ImU32 behind,
                         float turn_rad = 0.0f);

}  // namespace gaitsmith::shell
