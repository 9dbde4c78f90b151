// SPDX-License-Identifier: MIT
// What can be done with the clips of the timeline, as buttons.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// @param row   of the heading, what is left of it
/// @param below where rows of their own may begin, if the row is too short
/// @return where the tools in the row begin; its right end, if they are below
float DrawTimelineTools(Ui&, Session&, const ImRect& row, float below);

}  // namespace gaitsmith::shell
