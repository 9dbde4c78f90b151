// SPDX-License-Identifier: MIT
// The settings of the next search: algorithm, budget, seed, and the algorithm's own parameters.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// @param variation  whether the section of shared operators is open
void DrawSearchSettings(Ui&, Session&, bool& variation);

}  // namespace gaitsmith::shell
