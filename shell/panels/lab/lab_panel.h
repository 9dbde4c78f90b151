// SPDX-License-Identifier: MIT
// The Lab panel.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

void DrawLabPanel(Ui&, Session&);

}  // namespace gaitsmith::shell
