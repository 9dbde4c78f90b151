// SPDX-License-Identifier: MIT
// Play, step, scrub and speed, with a strip that shows the active rule over time.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

void DrawTransport(Ui&, Session&, const ImRect&);

}  // namespace gaitsmith::shell
