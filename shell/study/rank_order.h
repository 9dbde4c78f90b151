// SPDX-License-Identifier: MIT
// Which searches are ahead over several problems, and which differences are more than chance [Demsar 2006]:
// the searches are ranked in each block, their mean ranks compared, and all pairs corrected together [Holm
// 1979].
#pragma once

#include <span>
#include <vector>

namespace gaitsmith::shell {

struct RankOrder {
  struct Place {
    std::size_t search;  // as given
    double rank;         // mean over the blocks, 1 is best
  };
  std::vector<Place> places;  // best first
  struct Pair {
    std::size_t better, worse;  // places
    double p;                   // two-sided, Holm's of all pairs
  };
  std::vector<Pair> pairs;
  struct Group {
    std::size_t first, last;  // places, first < last
  };
  /// Neighbouring places whose differences may all be chance (p is 5 % or more), as many as possible in each.
  std::vector<Group> groups;
};

/// z = (R_i - R_j) / sqrt(k (k + 1) / (6 N)) for the mean ranks R of k searches in N blocks.
/// @param blocks what each search reached in a block, for example on one problem with one seed; each has as
///               many values as there are searches, at least two; higher is better, equal ones share their
///               ranks. At least one block
[[nodiscard]] RankOrder RankOrderOf(std::span<const std::vector<double>> blocks);

}  // namespace gaitsmith::shell
