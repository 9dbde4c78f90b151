// SPDX-License-Identifier: MIT
// Buttons for actions on the timeline's clips.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// @param row   free part of the heading's row
/// @param below the place for rows if that row is too short
/// @return the left edge of the tools in the row, or the row's right edge if they are below
float DrawTimelineTools(Ui&, Session&, const ImRect& row, const ImRect& below);

}  // namespace gaitsmith::shell
