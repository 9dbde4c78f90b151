// SPDX-License-Identifier: MIT
// How far a figure's state is from the states that a motion passes. The paper expects a controller to take
// over where the state is "reasonably close" to its own [Fukunaga 1994, section 6].
#pragma once

#include "core/rollout/motion.h"

namespace gaitsmith {

/// The distance of a state from the nearest of a motion's, without unit: the root of the mean square of the
/// differences in the root's turn (whole turns do not count) and its rate, the joints' angles and rates, and
/// the height and velocity of the centre of mass, in units of the longest rod l, sqrt(l / g) and 1 rad, with
/// g = 9.8 m/s^2. The place along the ground does not count.
/// @param frame  of `motion`, at least 1
/// @param usual  of the same figure
/// @param first  only frames of `usual` from this one on, in [1, usual.Frames())
[[nodiscard]] double StateDistance(const Motion& motion, int frame, const Motion& usual, int first);

}  // namespace gaitsmith
