// SPDX-License-Identifier: MIT
// Buttons for actions on the timeline's clips.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// @param row   free part of the heading's row
/// @param below top of additional rows, if that row is too short
/// @return the left end of the tools in the row; the row's right end if they are below
float DrawTimelineTools(Ui&, Session&, const ImRect& row, float below);

}  // namespace gaitsmith::shell
