// SPDX-License-Identifier: MIT
// What one clip's controller sensed and decided, step by step, for programs that run controllers without the
// simulator.
#pragma once

#include <vector>

#include "core/rollout/motion.h"

namespace gaitsmith {

struct Decision {
  int step = 0;  // since the start of the motion
  int rule = 0;  // the active rule; of a network the number of hidden nodes that fire; the nearest knot
  /// What the controller reads: normalised senses of rules; of a network 1 or 0 for the touch at each
  /// endpoint, and the angle of each joint [rad]; nothing of a trajectory.
  std::vector<float> senses;
  // By joint, after deciding: targets [rad], inverse time constants [1/s], and exp(-h / tau).
  std::vector<float> targets, inverse_tau, decay;
};

/// Simulates a motion and records one of its clips. The first decision is that of taking over, where nothing
/// has been sensed: its senses are 0. The last one is after the clip's last step.
/// @param clip an index of the script's clips
[[nodiscard]] std::vector<Decision> RecordDecisions(const Script& script, std::size_t clip);

}  // namespace gaitsmith
