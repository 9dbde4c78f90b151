// SPDX-License-Identifier: MIT
// Compares two samples by ranks, for skewed results of searches, where only the order has a meaning.
#pragma once

#include <span>
#include <vector>

namespace gaitsmith::shell {

struct RankComparison {
  double u;  // Mann-Whitney: number of pairs in which the first value is greater, ties counted half; [0, n m]
  double a12;  // Vargha-Delaney: the share u / (n m) of all pairs; 0.5 if neither sample tends to be greater
  double p;  // two-sided, by the normal approximation, corrected for ties and continuity; 1 if all are equal
};

/// [Mann Whitney 1947], [Vargha Delaney 2000] @param first, second not empty, no NaN
[[nodiscard]] RankComparison CompareRanks(std::span<const double> first, std::span<const double> second);

/// The p values of one family of comparisons, in the order given, corrected for testing all of them together
/// [Holm 1979].
[[nodiscard]] std::vector<double> HolmAdjusted(std::span<const double> p);

/// The value below which this share of the sample lies, interpolated between neighbours; 0.5 is the median.
/// @param sample not empty, no NaN  @param share [0, 1]
[[nodiscard]] double Quantile(std::span<const double> sample, double share);

}  // namespace gaitsmith::shell
