// SPDX-License-Identifier: MIT
// The newest motions as a row of small moving pictures.
#pragma once

#include <string>

#include "shell/session/session.h"
#include "shell/stage/motion_strip.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct FoundRailState {
  MotionStrips strips = {};
  std::string replacing = {};  // the motion that a person wants in place of several clips
};

/// As many as fit, the newest first. A press shows a motion, and asks before it replaces several clips; a
/// drag takes it to the timeline. @return whether all results are wanted
bool DrawFoundRail(Ui&, Session&, FoundRailState&, const ImRect&);

}  // namespace gaitsmith::shell
