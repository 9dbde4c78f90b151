// SPDX-License-Identifier: MIT
// What a goal looks like with a figure: small drawings, not simulations.
#pragma once

#include "core/document/goals.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct GoalInk {
  ImU32 figure, mark, behind;
};

/// @param rect  its lower edge is the ground
void DrawGoalPicture(Ui&, Goal, const Figure&, const ImRect& rect, const GoalInk&);

}  // namespace gaitsmith::shell
