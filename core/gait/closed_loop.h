// SPDX-License-Identifier: MIT
// A cycle of a motion as a loop: it ends exactly as it begins, so that it can be played again and again.
#pragma once

#include <vector>

#include "core/gait/gait_cycle.h"
#include "core/kinematics/kinematic_recorder.h"

namespace gaitsmith {

struct ClosedLoop {
  GaitCycle cycle;
  std::vector<KinematicFrame> frames;  // the last one is the first, moved on
  double distance_m = 0.0;             // along the ground in one cycle; negative: to the left
  int turns = 0;                       // whole turns in one cycle
  double seam_rods = 0.0;   // how far an endpoint of the last frame is from the first's [longest rod]
  double slide_rods = 0.0;  // by how much closing the seam slides a foot while it stands [longest rod]

  /// Steps of one cycle.
  [[nodiscard]] int Steps() const { return static_cast<int>(frames.size()) - 1; }
};

/// The most that a loop may differ at its seam, and may slide a standing foot [longest rod].
inline constexpr double kMostSeam = 0.01;

/// Closes the seam. The cycle is sampled at whole steps, so it is up to half a step faster or slower than
/// recorded; the last quarter of it is blended into its beginning. Feet that stand at the seam stay where
/// they are.
[[nodiscard]] ClosedLoop CloseLoop(const Motion& motion, const GaitCycle& cycle);

}  // namespace gaitsmith
