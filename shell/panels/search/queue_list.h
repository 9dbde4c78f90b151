// SPDX-License-Identifier: MIT
// The queue in the Search panel: the waiting searches in order, with buttons.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

void DrawQueue(Ui&, Session&);

}  // namespace gaitsmith::shell
