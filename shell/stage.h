// SPDX-License-Identifier: MIT
// The stage: the figure on its ruled ground, where it has been, what the ground does to it, and how far it
// got.
#pragma once

#include "shell/session.h"
#include "shell/widgets.h"

namespace gaitsmith::shell {

void DrawStage(Ui&, Session&, const ImRect&);

}  // namespace gaitsmith::shell
