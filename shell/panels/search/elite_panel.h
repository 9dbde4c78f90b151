// SPDX-License-Identifier: MIT
// The map of styles in the Search panel: one square per style, with a pose of its best motion, in a stronger
// colour for a better one. Click a square to view its motion.
#pragma once

#include "shell/session/session.h"
#include "shell/stage/motion_strip.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct EliteMapState {
  int turns = 0;  // the shown bin of the axis "turns"
  MotionStrips poses = {};
};

void DrawEliteMap(Ui&, Session&, EliteMapState&);

}  // namespace gaitsmith::shell
