// SPDX-License-Identifier: MIT
// The stage: the figure on its ruled ground, where it has been, what the ground does to it, and how far it
// got.
#pragma once

#include "shell/pinch.h"
#include "shell/push_gesture.h"
#include "shell/scene.h"
#include "shell/session.h"
#include "shell/widgets.h"
#include "shell/world_card.h"

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
