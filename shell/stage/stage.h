// SPDX-License-Identifier: MIT
// The stage: the figure on the ground with its ruler, past poses, contact forces, and the distance travelled.
#pragma once

#include "shell/session/session.h"
#include "shell/stage/ground/ground_gesture.h"
#include "shell/stage/pinch.h"
#include "shell/stage/push_gesture.h"
#include "shell/stage/scene.h"
#include "shell/stage/teach_gesture.h"
#include "shell/stage/world_card.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// The stage's state between frames: the view, and the gesture in progress.
struct StageState {
  CameraSettings gaze;
  bool panning = false;
  PushGesture push;
  TeachGesture teach;
  GroundGesture ground;
  Pinch pinch;
  WorldCardState world;
  int felt_rule = -1;           // what this rule of the selected clip feels is shown on the body; -1: none
  bool asks_for_rules = false;  // a button of the viewer was pressed: the rules should be shown
};

/// @param covered width at the right that a card covers [points]; the figure stays left of it
void DrawStage(Ui&, Session&, StageState&, const ImRect&, float covered = 0.0f);

}  // namespace gaitsmith::shell
