// SPDX-License-Identifier: MIT
// What the chosen keyframe asks for: when, the pose, the turn of the body, marks, rest.
#pragma once

#include "shell/panels/keyframes/stance_bars.h"
#include "shell/session/session.h"
#include "shell/stage/pose_board.h"

namespace gaitsmith::shell {

struct KeyframeFormState {
  int mark_endpoint = 0;  // of the next mark; 0: the centre of mass, k: endpoint k - 1
  LimbDrag drag{};
};

void DrawKeyframeForm(Ui&, Session&, KeyframeFormState&);

}  // namespace gaitsmith::shell
