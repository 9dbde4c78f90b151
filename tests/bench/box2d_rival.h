// SPDX-License-Identifier: MIT
// The peers' scenario in Box2D 2.4, with the settings its manual recommends: 60 steps per second, 8 velocity
// and 3 position iterations. To give Box2D every advantage, rods of a figure do not collide, nothing is
// drawn, and the targets are given.
#pragma once

#include "tests/bench/workload.h"

namespace gaitsmith::bench {

inline constexpr int kBox2dSteps = 600;

/// One rollout in a new world, with motors as strong as the workload's joints. @return the hub's final
/// position [m], so that the compiler cannot remove the work
[[nodiscard]] float RunInBox2d(const Workload& peers, int figure);

}  // namespace gaitsmith::bench
