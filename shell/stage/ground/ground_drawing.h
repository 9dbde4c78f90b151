// SPDX-License-Identifier: MIT
// The ground with its ruler: level, on a slope, or drawn.
#pragma once

#include "core/world/terrain.h"
#include "shell/stage/camera.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// Colour below the ground line, opaque.
[[nodiscard]] ImU32 GroundColour(const Palette&);

/// @param stage the part of the canvas that shows the ground
/// @param texts_until  labels of a drawn ground end above this height of the canvas
void DrawGround(Ui&, const ImRect& stage, const Camera&, const Terrain&, float texts_until);

/// Where a text on the ground has its centre, so that no part of it sticks out of a drawn ground.
/// @param x_m  of its centre @param half_width of the text, and its depth below the ground [points]
[[nodiscard]] ImVec2 BelowGround(const Camera&, const Terrain&, double x_m, float half_width, float depth);

}  // namespace gaitsmith::shell
