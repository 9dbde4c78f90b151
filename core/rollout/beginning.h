// SPDX-License-Identifier: MIT
// Where a beginning leaves the figure.
#pragma once

#include <span>
#include <vector>

#include "core/physics/motion_state.h"
#include "core/physics/skeleton.h"
#include "core/rollout/problem.h"

namespace gaitsmith {

/// The states of what a beginning does. @param problem its figure is the skeleton's; its own beginnings do
/// not matter @param steps since the start, ascending; the beginning goes on until the last of them
/// @return one for each step
[[nodiscard]] std::vector<Moment<1>> MomentsDuring(const Beginning&, const Problem& problem, const Skeleton&,
                                                   std::span<const int> steps);

}  // namespace gaitsmith
