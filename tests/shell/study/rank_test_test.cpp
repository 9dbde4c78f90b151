// SPDX-License-Identifier: MIT
// The rank test against the exact permutation distribution.
#include "shell/study/rank_test.h"

#include <bit>
#include <catch_amalgamated.hpp>
#include <cmath>

namespace gaitsmith::shell::test {

namespace {

using Sample = std::vector<double>;

/// U by its definition, without ranks: the number of pairs that the first sample wins, with ties counted
/// half.
double PairsWon(const Sample& first, const Sample& second) {
  double won = 0.0;
  for (const double a : first) {
    for (const double b : second) won += a > b ? 1.0 : a == b ? 0.5 : 0.0;
  }
  return won;
}

/// U of every split of the pooled values. Under the null hypothesis all are equally likely.
Sample AllSplits(const Sample& first, const Sample& second) {
  Sample all = first, deals;
  all.insert(all.end(), second.begin(), second.end());
  for (unsigned deal = 0; deal < 1u << all.size(); ++deal) {
    if (static_cast<std::size_t>(std::popcount(deal)) != first.size()) continue;
    Sample one, other;
    for (std::size_t i = 0; i < all.size(); ++i) ((deal >> i & 1u) != 0 ? one : other).push_back(all[i]);
    deals.push_back(PairsWon(one, other));
  }
  return deals;
}

double Mean(const Sample& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double Variance(const Sample& values) {
  Sample squares;
  for (const double value : values) squares.push_back((value - Mean(values)) * (value - Mean(values)));
  return Mean(squares);
}

/// The two-sided p: the share of splits at least as far from the mean as this U.
double ExactP(const Sample& deals, double u) {
  double far = 0.0;
  for (const double deal : deals)
    far += std::abs(deal - Mean(deals)) >= std::abs(u - Mean(deals)) - 1e-9 ? 1.0 : 0.0;
  return far / static_cast<double>(deals.size());
}

}  // namespace

TEST_CASE("rank test: U, moments and p agree with the permutation distribution", "[rank_test]") {
  // Without ties, with ties within and between samples, with unequal sizes, and with nearly equal values.
  const auto [first, second] = GENERATE(
      std::pair<Sample, Sample>{{1.5, 2.5, 3.25, 7.0, 8.5, 9.75, 11.0, 4.5},
                                {2.0, 10.5, 12.25, 13.0, 14.5, 6.25, 15.0, 16.5}},
      std::pair<Sample, Sample>{{3.0, 2.0, 5.0, 7.0, 7.0, 7.0, 3.0},
                                {3.0, 7.0, 7.0, 8.0, 8.0, 9.0, 5.0, 4.0}},
      std::pair<Sample, Sample>{{-1e9, 2.5, 2.5, 4.0, 6.0},
                                {2.5, 3.5, 4.0, 4.0, 5.5, 6.0, 6.5, 7.5, 8.5, 9.5}},
      std::pair<Sample, Sample>{{2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 3.0}, {2.0, 2.0, 3.0, 2.0, 3.0, 3.0, 2.0}});
  const RankComparison found = CompareRanks(first, second);
  CHECK(found.u == PairsWon(first, second));
  const auto pairs = static_cast<double>(first.size() * second.size());
  CHECK(found.a12 == found.u / pairs);

  const Sample deals = AllSplits(first, second);
  REQUIRE(Mean(deals) == Catch::Approx(pairs / 2.0));
  const double z = std::max(0.0, std::abs(found.u - pairs / 2.0) - 0.5) / std::sqrt(Variance(deals));
  CHECK(found.p == Catch::Approx(std::erfc(z / std::sqrt(2.0))).epsilon(1e-9));
  // The normal approximation is close, except for samples with only two distinct values: there U changes in
  // steps of seven, but the continuity correction assumes steps of one.
  if (first.front() != first[1]) CHECK(found.p == Catch::Approx(ExactP(deals, found.u)).margin(0.01));
}

TEST_CASE("rank test: published values of the first table", "[rank_test]") {
  // [Mann Whitney 1947], table 1: for n = m = 4, U = 0 has probability 0.014 = 1/70.
  const Sample low = {1.0, 2.0, 3.0, 4.0}, high = {5.0, 6.0, 7.0, 8.0};
  CHECK(CompareRanks(low, high).u == 0.0);
  CHECK(CompareRanks(high, low).u == 16.0);
  CHECK(CompareRanks(low, high).a12 == 0.0);
  CHECK(ExactP(AllSplits(low, high), 0.0) == Catch::Approx(2.0 / 70.0));
  // Two-sided at 5 %, n = m = 8: 13 is significant and 14 is not, both exactly and by the approximation.
  const Sample first = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 12.5, 13.5};
  for (const double moved : {0.0, 1.0}) {
    Sample second = {7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0};
    if (moved > 0.0) second[6] = 12.25;
    const double u = CompareRanks(first, second).u;
    REQUIRE(u == 13.0 + moved);
    const double exact = ExactP(AllSplits(first, second), u);
    CHECK((exact < 0.05) == (moved == 0.0));
    CHECK((CompareRanks(first, second).p < 0.055) == (moved == 0.0));
  }
}

TEST_CASE("rank test: symmetric, and p = 1 for equal samples", "[rank_test]") {
  const Sample first = {2.0, 3.0, 3.0, 7.0}, second = {3.0, 5.0, 8.0};
  CHECK(CompareRanks(first, second).p == CompareRanks(second, first).p);
  CHECK(CompareRanks(first, second).a12 + CompareRanks(second, first).a12 == 1.0);
  const Sample equal = {4.5, 4.5, 4.5};
  CHECK(CompareRanks(equal, equal).p == 1.0);
  CHECK(CompareRanks(equal, equal).a12 == 0.5);
  CHECK(CompareRanks(Sample{2.0}, Sample{3.0}).p == 1.0);
}

TEST_CASE("Holm: steps down from the smallest p, at most 1 and monotone", "[rank_test]") {
  // By hand: 0.01 x 4, 0.02 x 3, 0.03 x 2 = 0.06 again, 0.7 x 1.
  const std::vector<double> p = {0.03, 0.01, 0.7, 0.02};
  const std::vector<double> adjusted = HolmAdjusted(p);
  const std::vector<double> expected = {0.06, 0.04, 0.7, 0.06};
  for (std::size_t i = 0; i < p.size(); ++i) CHECK(adjusted[i] == Catch::Approx(expected[i]));
  CHECK(HolmAdjusted(std::vector<double>{0.6, 0.9, 0.7}) == std::vector<double>{1.0, 1.0, 1.0});
  CHECK(HolmAdjusted({}).empty());
}

TEST_CASE("quantiles: medians and quartiles of odd, even and single samples", "[rank_test]") {
  CHECK(Quantile(Sample{7.0, 2.0, 5.0}, 0.5) == 5.0);
  CHECK(Quantile(Sample{7.0, 2.0, 5.0, 4.0}, 0.5) == 4.5);
  CHECK(Quantile(Sample{7.0, 2.0, 5.0, 4.0}, 0.25) == 3.5);
  CHECK(Quantile(Sample{7.0, 2.0, 5.0, 4.0}, 0.75) == 5.5);
  CHECK(Quantile(Sample{3.5}, 0.25) == 3.5);
  CHECK(Quantile(Sample{7.0, 2.0}, 1.0) == 7.0);
}

}  // namespace gaitsmith::shell::test
