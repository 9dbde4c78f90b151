// SPDX-License-Identifier: MIT
// The map of styles in the Search panel: a square for each style that has a motion, with a stronger colour
// for a better one. Click a square to view its motion.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// @param turns  the shown bin of turns
void DrawEliteMap(Ui&, Session&, int& turns);

}  // namespace gaitsmith::shell
