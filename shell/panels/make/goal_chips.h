// SPDX-License-Identifier: MIT
// Goals to choose from, as pictures of the open document's figure.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// Draws the goals in one or two rows, and below them a line about the one that is pointed at, else the
/// chosen one.
void DrawGoalChips(Ui&, Session&);

}  // namespace gaitsmith::shell
