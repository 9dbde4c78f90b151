// SPDX-License-Identifier: MIT
// The Style panel: what counts as a good motion, and what the present one scores.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

void DrawStylePanel(Ui&, Session&);

}  // namespace gaitsmith::shell
