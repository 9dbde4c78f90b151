// SPDX-License-Identifier: MIT
// A motion that was not simulated, frame by frame, as if it had been: for drawing, measuring and exporting
// it.
#pragma once

#include <span>
#include <vector>

#include "core/kinematics/posture.h"

namespace gaitsmith {

struct KinematicFrame {
  Posture posture;
  std::vector<Motion::Point> forces;  // of the ground on endpoints [N] (endpoints)
  int clip = -1, rule = -1;           // as in Motion::Frame
};

/// Rates are differences from frame to frame, and lengths of muscles are between their nodes. Of the terms
/// only travel, height and rotations are measured; nothing is sensed.
/// @param script of the figure; its steps and controllers are not used
/// @param frames at least two, one per step
[[nodiscard]] Motion RecordKinematic(Script script, std::span<const KinematicFrame> frames);

}  // namespace gaitsmith
