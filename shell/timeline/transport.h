// SPDX-License-Identifier: MIT
// Play, step, scrub and speed, with the strip that shows which rule was active when.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

void DrawTransport(Ui&, Session&, const ImRect&);

}  // namespace gaitsmith::shell
