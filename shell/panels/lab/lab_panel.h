// SPDX-License-Identifier: MIT
// The Lab panel.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct LabPanelState {
  bool targets = false;         // whether the section of running times is open
  bool all_algorithms = false;  // whether those for experts can be chosen
};

void DrawLabPanel(Ui&, Session&, LabPanelState&);

}  // namespace gaitsmith::shell
