// SPDX-License-Identifier: MIT
// The three choices of a first visit: what the figure should do, what it feels, and how long the computer
// tries.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

void DrawMakePanel(Ui&, Session&);

}  // namespace gaitsmith::shell
