// SPDX-License-Identifier: MIT
// The stage: the figure on its ruled ground, where it has been, what the ground does to it, and how far it
// got.
#pragma once

#include "shell/session/session.h"
#include "shell/stage/pinch.h"
#include "shell/stage/push_gesture.h"
#include "shell/stage/scene.h"
#include "shell/stage/world_card.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// What the stage remembers between frames: where a person looks, and what they hold.
struct StageState {
  Gaze gaze;
  bool panning = false;
  PushGesture push;
  Pinch pinch;
  WorldCardState world;
};

/// @param covered of its right side by a card, which the figure keeps out of [points]
void DrawStage(Ui&, Session&, StageState&, const ImRect&, float covered = 0.0f);

}  // namespace gaitsmith::shell
