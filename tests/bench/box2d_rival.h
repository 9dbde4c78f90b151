// SPDX-License-Identifier: MIT
// The peers' scenario in Box2D 2.4, as its manual recommends: 60 steps per second, 8 velocity and 3 position
// iterations. Everything that could only slow it down is left out: rods of a figure do not collide, nothing
// is drawn, and the targets are given.
#pragma once

#include "tests/bench/workload.h"

namespace gaitsmith::bench {

inline constexpr int kBox2dSteps = 600;

/// One rollout in a new world. @return the hub's final position [m], so that the compiler cannot remove the
/// work
[[nodiscard]] float RunInBox2d(const Workload& peers, int figure);

}  // namespace gaitsmith::bench
