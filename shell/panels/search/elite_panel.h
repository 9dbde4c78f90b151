// SPDX-License-Identifier: MIT
// The map of styles in the Search panel: one square per style, in a stronger colour for a better motion.
// Click a square to view its motion.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// @param turns  the shown bin of the axis "turns"
void DrawEliteMap(Ui&, Session&, int& turns);

}  // namespace gaitsmith::shell
