// SPDX-License-Identifier: MIT
// Keyframes and the times of standing over the time of a plan: a row of diamonds, and under it a row of bars
// for each endpoint.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct StanceBarsState {
  int keyframe = 0;  // the chosen one
  int stance = -1;   // the chosen one; -1: none
  int grip = 0;      // which end of the chosen bar is dragged: -1 the first, 1 the last, 0 none
};

void DrawStanceBars(Ui&, Session&, StanceBarsState&);

}  // namespace gaitsmith::shell
