// SPDX-License-Identifier: MIT
// The Style panel: the weights that define a good motion, and the score of the present one.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

void DrawStylePanel(Ui&, Session&);

}  // namespace gaitsmith::shell
