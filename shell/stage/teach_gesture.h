// SPDX-License-Identifier: MIT
// Showing the figure on the stage what it should do: a drag draws a way for its centre of mass, or turns a
// limb of the pose that it should take.
#pragma once

#include "shell/stage/limb_grip.h"
#include "shell/stage/scene.h"

namespace gaitsmith::shell {

struct TeachGesture {
  std::vector<WayPoint> drawn;  // the way so far, on the ground
  LimbGrip grip;
  Camera::Place centre{0.0, 0.0f};  // of the pose while it is turned: the motion may change meanwhile
};

/// The stage's drag, while the teacher has a tool in hand.
void TeachByHand(Session&, TeachGesture&, const Scene&, const Touch& stage, CameraSettings&);

/// Draws the way, with a ring at the place for the shown moment, and the pose where the motion is at its
/// moment.
/// @param pointed  the stage is pointed at
void DrawShown(const Scene&, const TeachGesture&, bool pointed);

}  // namespace gaitsmith::shell
