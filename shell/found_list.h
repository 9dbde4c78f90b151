// SPDX-License-Identifier: MIT
// The found motions in the Search panel: a press shows one; each can be kept and deleted.
#pragma once

#include "shell/session.h"
#include "shell/widgets.h"

namespace gaitsmith::shell {

void DrawFound(Ui&, Session&, FoundMotions::Order&);

}  // namespace gaitsmith::shell
