// SPDX-License-Identifier: MIT
// Two aims at once: what cannot be better at one without being worse at the other is a front.
#pragma once

#include <span>
#include <vector>

namespace gaitsmith {

/// What a motion is good for. More is better in both.
struct Aims {
  float score = 0.0f;
  float thrift = 0.0f;  // minus its cost
};

/// Whether a is better than b in one aim and no worse in the other.
[[nodiscard]] constexpr bool Dominates(const Aims& a, const Aims& b) {
  return a.score >= b.score && a.thrift >= b.thrift && (a.score > b.score || a.thrift > b.thrift);
}

/// Non-dominated sorting [Deb et al. 2002]: 0 for those that none dominates, 1 for those that only they
/// dominate, and so on. In O(n log n), which two aims allow [Jensen 2003]. @param aims no NaN
[[nodiscard]] std::vector<int> FrontsOf(std::span<const Aims> aims);

/// Crowding distance [Deb et al. 2002] of each member within its front: the sum over the aims of the distance
/// between its neighbours, as a share of the front's extent. Infinite at a front's ends.
/// @param fronts as FrontsOf returns them
[[nodiscard]] std::vector<double> CrowdingOf(std::span<const Aims> aims, std::span<const int> fronts);

}  // namespace gaitsmith
