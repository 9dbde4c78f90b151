// SPDX-License-Identifier: MIT
// The Search panel: how to look for a better motion, and how far the search has come.
#pragma once

#include "shell/session.h"
#include "shell/widgets.h"

namespace gaitsmith::shell {

void DrawSearchPanel(Ui&, Session&);

}  // namespace gaitsmith::shell
