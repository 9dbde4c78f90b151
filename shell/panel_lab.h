// SPDX-License-Identifier: MIT
// The Lab panel.
#pragma once

#include "shell/session.h"
#include "shell/widgets.h"

namespace gaitsmith::shell {

void DrawLabPanel(Ui&, Session&);

}  // namespace gaitsmith::shell
