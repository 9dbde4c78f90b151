// SPDX-License-Identifier: MIT
// The settings of the next search: algorithm, budget, seed, and the algorithm's own parameters.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct SearchFormState {
  bool variation = false;       // whether the section of shared operators is open
  bool all_algorithms = false;  // whether the list has those for experts
};

void DrawSearchSettings(Ui&, Session&, SearchFormState&);

}  // namespace gaitsmith::shell
