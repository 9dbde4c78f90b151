// SPDX-License-Identifier: MIT
// The stage: the figure on its ruled ground, its past poses, the ground's forces, and the distance travelled.
#pragma once

#include "shell/session/session.h"
#include "shell/stage/pinch.h"
#include "shell/stage/push_gesture.h"
#include "shell/stage/scene.h"
#include "shell/stage/world_card.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// The stage's state between frames: the view, and the gesture in progress.
struct StageState {
  Gaze gaze;
  bool panning = false;
  PushGesture push;
  Pinch pinch;
  WorldCardState world;
};

/// @param covered width of its right side that a card covers; the figure stays out of it [points]
void DrawStage(Ui&, Session&, StageState&, const ImRect&, float covered = 0.0f);

}  // namespace gaitsmith::shell
