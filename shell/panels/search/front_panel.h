// SPDX-License-Identifier: MIT
// The front of NSGA-II in the Search panel: one point per motion, its cost to the right and its score
// upwards. Click a point to view its motion; a pose of it stands in the corner that no front reaches.
#pragma once

#include "shell/session/session.h"
#include "shell/stage/motion_strip.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct FrontState {
  std::size_t pointed = 0;  // the motion whose pose is shown
  MotionStrips poses = {};
};

void DrawFront(Ui&, Session&, FrontState&);

}  // namespace gaitsmith::shell
