// SPDX-License-Identifier: MIT
#include "shell/study/rank_test.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gaitsmith::shell {

RankComparison CompareRanks(std::span<const double> first, std::span<const double> second) {
  struct Value {
    double value;
    bool first;
  };
  std::vector<Value> all;
  for (const double value : first) all.push_back({value, true});
  for (const double value : second) all.push_back({value, false});
  std::ranges::sort(all, {}, &Value::value);

  // Equal values share the mean of their ranks.
  double rank_sum = 0.0, ties = 0.0;
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    std::size_t of_first = 0;
    for (end = begin; end < all.size() && all[end].value == all[begin].value; ++end) {
      of_first += all[end].first ? 1 : 0;
    }
    const auto equals = static_cast<double>(end - begin);
    rank_sum += static_cast<double>(of_first) * (static_cast<double>(begin + 1 + end) / 2.0);
    ties += equals * equals * equals - equals;
  }

  const auto n = static_cast<double>(first.size()), m = static_cast<double>(second.size()), all_n = n + m;
  const double u = rank_sum - n * (n + 1.0) / 2.0;
  const double variance = n * m / 12.0 * (all_n + 1.0 - ties / (all_n * (all_n - 1.0)));
  RankComparison comparison{.u = u, .a12 = u / (n * m), .p = 1.0};
  if (variance > 0.0) {
    const double z = std::max(0.0, std::abs(u - n * m / 2.0) - 0.5) / std::sqrt(variance);
    comparison.p = std::erfc(z / std::sqrt(2.0));
  }
  return comparison;
}

std::vector<double> HolmAdjusted(std::span<const double> p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(p[i], i); });
  std::vector<double> adjusted(p.size());
  double least = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    least = std::max(least, std::min(1.0, p[order[i]] * static_cast<double>(p.size() - i)));
    adjusted[order[i]] = least;
  }
  return adjusted;
}

double Quantile(std::span<const double> sample, double share) {
  std::vector<double> sorted(sample.begin(), sample.end());
  std::ranges::sort(sorted);
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace gaitsmith::shell
