// SPDX-License-Identifier: MIT
// How deep rods and nodes are in drawn ground: the law that it lets nothing in.
#pragma once

#include "core/rollout/motion.h"
#include "core/world/terrain.h"

namespace gaitsmith::test {

/// The greatest depth of points along a rod between two places, by a hundredth of it [m].
[[nodiscard]] double DepthOfRod(const Terrain& terrain, double ax, double ay, double bx, double by);

/// Of all rods of a figure, or of all its nodes.
[[nodiscard]] double DepthOf(const Terrain& terrain, const Motion& motion, int frame);

}  // namespace gaitsmith::test
