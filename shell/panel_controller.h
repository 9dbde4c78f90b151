// SPDX-License-Identifier: MIT
// The Controller panel: what the figure senses, and its rules as cards.
#pragma once

#include "shell/session.h"
#include "shell/widgets.h"

namespace gaitsmith::shell {

void DrawControllerPanel(Ui&, Session&);

}  // namespace gaitsmith::shell
