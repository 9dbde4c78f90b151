// SPDX-License-Identifier: MIT
// How soon searches reach targets [Hansen Auger Ros Mersmann Tusar Brockhoff 2021]: not how good they are
// after a budget, but how many evaluations it takes to be as good as that.
#pragma once

#include <span>
#include <vector>

#include "shell/study/study_plan.h"

namespace gaitsmith::shell {

/// The best so far of one trial at each point of its plan (BestAtPoints); -infinity or a void score before
/// its first motion.
using Progress = std::vector<float>;

inline constexpr int kTargets = 20;

/// Targets that tell searches apart, rising evenly from the median of what the trials have at the first point
/// to the best of all; one where these are the same, none without a motion. Each has six digits, as it is
/// printed, and is rounded down; scores that differ by less have equal targets.
/// @param trials of all searches on one problem
[[nodiscard]] std::vector<double> TargetsOf(std::span<const Progress> trials, int count = kTargets);

/// The share of all pairs of a trial and a target that are reached, at each point: the empirical distribution
/// of running times, [0, 1].
[[nodiscard]] std::vector<double> ShareReached(std::span<const Progress> trials,
                                               std::span<const double> targets);

/// The expected running time: the evaluations of all trials until they reached the target, or to their end,
/// for each that did. Infinite if none did.
struct RunningTime {
  int reached = 0;   // trials that did
  double expected;   // evaluations
  double low, high;  // of the middle 95 % of 1000 bootstrap samples of the trials [Efron 1979]
};
/// @param trials of one search, at least one
[[nodiscard]] RunningTime RunningTimeTo(double target, std::span<const Progress> trials, const StudyPlan&);

}  // namespace gaitsmith::shell
