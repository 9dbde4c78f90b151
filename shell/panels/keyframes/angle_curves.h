// SPDX-License-Identifier: MIT
// The curve view of keyframes: each joint's angle over the time of the plan, and the angles that keyframes
// ask for, which can be dragged.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// @param joint whose angles can be dragged; another one if a curve is pressed
void DrawAngleCurves(Ui&, Session&, int& joint);

}  // namespace gaitsmith::shell
