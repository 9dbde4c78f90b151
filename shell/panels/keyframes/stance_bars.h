// SPDX-License-Identifier: MIT
// Keyframes and the times of standing over the time of a plan: a row of diamonds, and under it a row of bars
// for each endpoint.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// The time of a plan in seconds.
inline constexpr auto kSecondsPerStep = static_cast<double>(kStep);

struct StanceBarsState {
  int keyframe = 0;  // the chosen one
  int stance = -1;   // the chosen one; -1: none
};

void DrawStanceBars(Ui&, Session&, StanceBarsState&);

}  // namespace gaitsmith::shell
