// SPDX-License-Identifier: MIT
#include "core/gait/gait_cycle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/gait/cycle_ends.h"
#include "core/numeric/hundredths.h"

namespace gaitsmith {

namespace {

/// Below this, a figure stands still [longest rod].
constexpr double kLiveliness = 0.01;
/// A shorter period is taken instead of the best one if it is nearly as good: it may lack this many times as
/// much of a perfect likeness, and this much more.
constexpr double kAlmostTimes = 1.5, kAlmost = 0.02;
/// Parts of a frame to which the period is determined.
constexpr int kParts = 20;

std::unexpected<Error> NoCycle(std::string why) { return Fail(ErrorCode::kMissing, "", std::move(why)); }

/// The shortest lag with a peak of likeness that is nearly the best. @return 0 without any peak
int PeriodOf(const std::vector<double>& likeness) {
  const auto peak = [&](std::size_t lag) {
    return likeness[lag] >= likeness[lag - 1] && likeness[lag] > likeness[lag + 1];
  };
  double best = -1.0;
  for (std::size_t lag = kShortestCycle; lag + 1 < likeness.size(); ++lag) {
    if (peak(lag)) best = std::max(best, likeness[lag]);
  }
  for (std::size_t lag = kShortestCycle; lag + 1 < likeness.size(); ++lag) {
    if (peak(lag) && 1.0 - likeness[lag] <= kAlmostTimes * (1.0 - best) + kAlmost)
      return static_cast<int>(lag);
  }
  return 0;
}

}  // namespace

Result<GaitCycle> FindCycle(const Motion& motion, int first, int last, bool halves) {
  const auto seconds = [&](int frames) { return InHundredths(frames * static_cast<double>(motion.StepS())); };
  if (motion.TermsAt(last).broke_physics) return NoCycle("the motion is void, so it has no cycle");
  const int longest = std::min(kLongestCycle, (last - first) / 2);
  if (longest <= kShortestCycle) {
    return NoCycle(seconds(std::max(last - first, 0)) +
                   " s are too short to repeat: a cycle must be seen twice (" +
                   seconds(2 * kShortestCycle + 2) + " s at least)");
  }
  const LimbPairs pairs = halves ? LimbPairsOf(motion.Bones()) : LimbPairs();
  if (halves && !pairs.any) return NoCycle("the figure has no two limbs that can take each other's part");
  const Likeness likeness(motion, first, last, pairs);
  if (likeness.Liveliness() < kLiveliness) {
    return NoCycle("the figure stands still: its parts move by " + InHundredths(likeness.Liveliness()) +
                   (motion.Bones().rods == 0 ? " of the longest spring (" : " of the longest rod (") +
                   InHundredths(kLiveliness) + " at least)");
  }
  std::vector<double> after(static_cast<std::size_t>(longest) + 1, -1.0);
  for (int lag = kShortestCycle - 1; lag <= longest; ++lag)
    after[static_cast<std::size_t>(lag)] = likeness.After(lag);
  const int period = PeriodOf(after);
  if (period == 0) {
    return NoCycle("it never becomes like itself again: its likeness only falls, from " +
                   seconds(kShortestCycle) + " s to " + seconds(longest) + " s later");
  }
  const double best = after[static_cast<std::size_t>(period)];
  if (best < kLeastLikeness) {
    return NoCycle("it does not repeat: it is most like itself " + seconds(period) + " s later, by " +
                   InHundredths(std::max(best, 0.0)) + ", and a cycle by " + InHundredths(kLeastLikeness));
  }

  // Cut it where the ends fit best.
  const CycleEnds ends(motion, pairs);
  const int reach = std::max(2, period / 16);
  double least = std::numeric_limits<double>::infinity();
  GaitCycle cycle{.likeness = best, .half = halves};
  for (int begin = first; begin + period + reach + 1 <= last; ++begin) {
    for (int frames = period - reach; frames <= period + reach; ++frames) {
      const double misfit = ends.Misfit(begin, begin + frames);
      if (misfit >= least) continue;
      least = misfit;
      cycle.first = begin;
      cycle.frames = frames;
    }
  }
  const double whole = cycle.frames;
  for (int part = 1 - kParts; part < kParts; ++part) {
    const double frames = whole + static_cast<double>(part) / kParts;
    const double misfit = ends.Misfit(cycle.first, cycle.first + frames);
    if (misfit >= least) continue;
    least = misfit;
    cycle.frames = frames;
  }
  cycle.turns = ends.Turns(cycle.first, cycle.first + cycle.frames);
  cycle.gap_rods = ends.GapRods(cycle.first, cycle.first + cycle.frames);
  return cycle;
}

}  // namespace gaitsmith
