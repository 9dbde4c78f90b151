// SPDX-License-Identifier: MIT
// The peers' scenario in Box2D 2.4, as its manual recommends: 60 steps a second, 8 velocity and 3 position
// iterations. Whatever could only slow it down is left out: rods of a figure do not collide, nothing is
// drawn, and the targets are found without searching.
#pragma once

#include "tests/bench/workload.h"

namespace gaitsmith::bench {

inline constexpr int kBox2dSteps = 600;

/// One rollout in a new world. @return where its hub ends up [m], so that nothing can be left out as unused
[[nodiscard]] float RunInBox2d(const Workload& peers, int figure);

}  // namespace gaitsmith::bench
