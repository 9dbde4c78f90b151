// SPDX-License-Identifier: MIT
// How long a motion is off the ground.
#pragma once

#include <algorithm>

#include "core/rollout/motion.h"

namespace gaitsmith::test {

/// True if no endpoint bears load in this frame.
inline bool InFlight(const Motion& motion, int frame) {
  for (int e = 0; e < motion.Bones().endpoints; ++e) {
    if (motion.Force(frame, e).y > 0.0f) return false;
  }
  return true;
}

/// The longest run of frames without contact from frame `first` to frame `last`.
inline int LongestFlight(const Motion& motion, int first, int last) {
  int longest = 0, flight = 0;
  for (int frame = first; frame <= last; ++frame) {
    flight = InFlight(motion, frame) ? flight + 1 : 0;
    longest = std::max(longest, flight);
  }
  return longest;
}

}  // namespace gaitsmith::test
