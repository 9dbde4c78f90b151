// SPDX-License-Identifier: MIT
// The queue in the Search panel: what waits, in which order, and what may be done to it.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

void DrawQueue(Ui&, Session&);

}  // namespace gaitsmith::shell
