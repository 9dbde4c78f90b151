// SPDX-License-Identifier: MIT
// "Make a suite" in the Search panel: the choice of its searches, and the button that queues them.
#pragma once

#include "shell/results/suite_plan.h"
#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

void DrawSuiteForm(Ui&, Session&, SuiteChoice&);

}  // namespace gaitsmith::shell
