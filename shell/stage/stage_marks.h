// SPDX-License-Identifier: MIT
// The marks of keyframes on the stage, which can be dragged or moved by arrow keys.
#pragma once

#include "shell/stage/scene.h"

namespace gaitsmith::shell {

/// Whether the stage shows the document's keyframes: their panel is open.
[[nodiscard]] bool ShowsKeyframes(const Session&);

/// Draws all marks; those of the chosen keyframe are filled.
void DrawMarks(Session&, const Scene&);

}  // namespace gaitsmith::shell
