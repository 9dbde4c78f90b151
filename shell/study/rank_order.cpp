// SPDX-License-Identifier: MIT
#include "shell/study/rank_order.h"

#include <algorithm>
#include <cmath>

#include "shell/study/rank_test.h"

namespace gaitsmith::shell {

namespace {

constexpr double kLevel = 0.05;

/// Ranks from 1 for the greatest; equal values share the mean of theirs.
std::vector<double> RanksOf(const std::vector<double>& values) {
  std::vector<double> ranks;
  ranks.reserve(values.size());
  for (const double value : values) {
    const auto above = std::ranges::count_if(values, [&](double other) { return other > value; });
    const auto equal = std::ranges::count(values, value);
    ranks.push_back(static_cast<double>(above) + (static_cast<double>(equal) + 1.0) / 2.0);
  }
  return ranks;
}

}  // namespace

RankOrder RankOrderOf(std::span<const std::vector<double>> blocks) {
  const std::size_t searches = blocks[0].size();
  std::vector<double> sums(searches, 0.0);
  for (const std::vector<double>& block : blocks) {
    const std::vector<double> ranks = RanksOf(block);
    for (std::size_t i = 0; i < searches; ++i) sums[i] += ranks[i];
  }
  RankOrder order;
  const auto n = static_cast<double>(blocks.size()), k = static_cast<double>(searches);
  for (std::size_t i = 0; i < searches; ++i) order.places.push_back({i, sums[i] / n});
  std::ranges::sort(order.places, {},
                    [](const RankOrder::Place& one) { return std::pair(one.rank, one.search); });

  std::vector<double> p;
  const double error = std::sqrt(k * (k + 1.0) / (6.0 * n));
  for (std::size_t a = 0; a < searches; ++a) {
    for (std::size_t b = a + 1; b < searches; ++b) {
      p.push_back(std::erfc((order.places[b].rank - order.places[a].rank) / error / std::sqrt(2.0)));
      order.pairs.push_back({a, b, 1.0});
    }
  }
  const std::vector<double> adjusted = HolmAdjusted(p);
  std::vector<std::vector<bool>> apart(searches, std::vector<bool>(searches, false));
  for (std::size_t i = 0; i < adjusted.size(); ++i) {
    RankOrder::Pair& pair = order.pairs[i];
    pair.p = adjusted[i];
    apart[pair.better][pair.worse] = pair.p < kLevel;
  }
  std::size_t reached = 0;  // by the groups so far
  for (std::size_t first = 0; first < searches; ++first) {
    std::size_t last = first;
    while (last + 1 < searches && !apart[first][last + 1]) ++last;
    if (last > first && (order.groups.empty() || last > reached)) {
      order.groups.push_back({first, last});
      reached = last;
    }
  }
  return order;
}

}  // namespace gaitsmith::shell
