// SPDX-License-Identifier: MIT
// The map of styles in the Search panel: a square for each style that has a motion, stronger where that is
// better; a press shows the motion.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// @param turns  the bin of turns that is shown
void DrawEliteMap(Ui&, Session&, int& turns);

}  // namespace gaitsmith::shell
