// SPDX-License-Identifier: MIT
// The ground with its ruler, level or on a slope.
#pragma once

#include "shell/stage/camera.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// Colour below the ground line, opaque.
[[nodiscard]] ImU32 GroundColour(const Palette&);

/// @param stage the part of the canvas that shows the ground
void DrawGround(Ui&, const ImRect& stage, const Camera&);

}  // namespace gaitsmith::shell
