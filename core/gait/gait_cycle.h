// SPDX-License-Identifier: MIT
// The cycle of a motion: the part of it that repeats.
#pragma once

#include "core/gait/likeness.h"
#include "core/numeric/error.h"

namespace gaitsmith {

struct GaitCycle {
  int first = 0;          // frame where it begins
  double frames = 0.0;    // its duration; need not be whole
  double likeness = 0.0;  // of the motion to itself one cycle later: see Likeness
  int turns = 0;          // whole turns of the figure in one cycle, counter-clockwise ones positive
  double gap_rods = 0.0;  // how far an endpoint is at most from where it was a cycle before [longest rod]
  bool half = false;      // only half of it was found: the other half is the same with limbs exchanged

  /// Of the whole cycle.
  [[nodiscard]] double PeriodS() const { return (half ? 2.0 : 1.0) * frames * static_cast<double>(kStep); }
};

/// The least likeness of a cycle.
inline constexpr double kLeastLikeness = 0.8;
/// The shortest and the longest cycle that is looked for [frames].
inline constexpr int kShortestCycle = 15, kLongestCycle = 400;

/// The shortest cycle of a motion that repeats at least once, cut where its ends fit best.
/// @param first, last the frames to look at
/// @param halves      look for half of a cycle instead, after which limbs have taken each other's part
/// @return an error that says, with numbers, why there is none
[[nodiscard]] Result<GaitCycle> FindCycle(const Motion& motion, int first, int last, bool halves);

}  // namespace gaitsmith
