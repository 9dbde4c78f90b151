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
  int stance = -1;  // the chosen one; -1: the chosen keyframe is open
};

/// A keyframe's sign.
void DrawDiamond(const Ui&, ImVec2 at, ImU32 fill, ImU32 edge);

void DrawStanceBars(Ui&, Session&, StanceBarsState&);

}  // namespace gaitsmith::shell
