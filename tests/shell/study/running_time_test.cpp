// SPDX-License-Identifier: MIT
// Running times to targets, and orders by rank, against cases that can be counted by hand.
#include "shell/study/running_time.h"

#include <catch_amalgamated.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "core/numeric/random.h"
#include "shell/study/rank_order.h"

namespace gaitsmith::shell::test {

namespace {

constexpr float kNone = -std::numeric_limits<float>::infinity();

StudyPlan TenPoints() {
  StudyPlan plan;
  plan.evaluations = 1000;
  plan.points = 10;
  return plan;
}

Progress Rising(float first, float step, int points = 10) {
  Progress progress;
  for (int i = 0; i < points; ++i) progress.push_back(first + step * static_cast<float>(i));
  return progress;
}

}  // namespace

TEST_CASE("running time: evaluations of all trials for each that reached the target", "[study]") {
  const StudyPlan plan = TenPoints();
  // Reached at 300, at 100, never.
  const std::vector<Progress> trials = {Rising(1.0f, 1.0f), Rising(3.0f, 1.0f), Rising(0.0f, 0.1f)};
  const RunningTime time = RunningTimeTo(3.0, trials, plan);
  CHECK(time.reached == 2);
  CHECK(time.expected == (300.0 + 100.0 + 1000.0) / 2.0);
  CHECK(time.low >= 100.0);
  CHECK(time.low < time.expected);
  CHECK(time.high > time.expected);
  // All alike: there is nothing to doubt.
  const std::vector<Progress> alike(5, Rising(1.0f, 1.0f));
  const RunningTime sure = RunningTimeTo(3.0, alike, plan);
  CHECK(sure.low == 300.0);
  CHECK(sure.expected == 300.0);
  CHECK(sure.high == 300.0);
  const RunningTime never = RunningTimeTo(99.0, trials, plan);
  CHECK(never.reached == 0);
  CHECK(std::isinf(never.expected));
  CHECK(std::isinf(never.low));
  // The same bits again.
  CHECK(RunningTimeTo(3.0, trials, plan).high == time.high);
}

TEST_CASE("running time: the bootstrap covers what it should", "[study]") {
  // Trials that reach the target after a number of evaluations that is uniform from 100 to 1000: 550
  // expected.
  const StudyPlan plan = TenPoints();
  int covered = 0;
  constexpr int kRounds = 200;
  for (std::uint64_t round = 0; round < kRounds; ++round) {
    RandomStream random(9, round, 0);
    std::vector<Progress> trials;
    for (int i = 0; i < 20; ++i) {
      Progress progress(10, 0.0f);
      for (std::size_t point = random.Below(10); point < 10; ++point) progress[point] = 1.0f;
      trials.push_back(std::move(progress));
    }
    const RunningTime time = RunningTimeTo(1.0, trials, plan);
    covered += time.low <= 550.0 && 550.0 <= time.high ? 1 : 0;
  }
  CHECK(covered > 0.88 * kRounds);
  CHECK(covered < kRounds);
}

TEST_CASE("targets: from the median of what is there at first to the best of all", "[study]") {
  const std::vector<Progress> trials = {Rising(1.0f, 1.0f), Rising(3.0f, 0.5f), {kNone, kNone, 2.0f}};
  const std::vector<double> targets = TargetsOf(trials, 4);
  CHECK(targets == std::vector<double>{4.0, 6.0, 8.0, 10.0});  // from 2 to 10
  CHECK(TargetsOf(std::vector<Progress>{{kNone, kNone}, {-1e9f, -1e9f}}).empty());
  CHECK(TargetsOf(std::vector<Progress>{{5.0f, 5.0f}}) == std::vector<double>{5.0});
  CHECK(TargetsOf({}).empty());
}

TEST_CASE("targets: a printed one is what was meant, and reached by the trial that set it", "[study]") {
  const float best = GENERATE(20.09115f, 14.22905f, -3.1415927f, 0.0f, 9.9999999e-7f, 123456.79f, 999999.5f);
  const double target = TargetsOf(std::vector<Progress>{{best, best}}).back();
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", target);
  CAPTURE(best, text);
  CHECK(std::strtod(text, nullptr) == target);
  CHECK(target <= static_cast<double>(best));
  CHECK(target >= static_cast<double>(best) - 1e-5 * std::abs(static_cast<double>(best)));
}

TEST_CASE("shares: of all trials and targets, at each point", "[study]") {
  const std::vector<Progress> trials = {{1.0f, 2.0f, 4.0f}, {kNone, 1.0f, 1.0f}};
  const std::vector<double> targets = {1.0, 4.0};
  CHECK(ShareReached(trials, targets) == std::vector<double>{0.25, 0.5, 0.75});
  CHECK(ShareReached(trials, {}) == std::vector<double>{0.0, 0.0, 0.0});
  CHECK(ShareReached({}, targets).empty());
}

TEST_CASE("rank order: mean ranks, equal values share theirs", "[study]") {
  const std::vector<std::vector<double>> blocks = {{1.0, 3.0, 2.0}, {5.0, 5.0, 1.0}};
  const RankOrder order = RankOrderOf(blocks);
  REQUIRE(order.places.size() == 3);
  CHECK(order.places[0].search == 1);
  CHECK(order.places[0].rank == 1.25);  // 1 and 1.5
  CHECK(order.places[1].search == 0);
  CHECK(order.places[1].rank == 2.25);  // 3 and 1.5
  CHECK(order.places[2].rank == 2.5);   // 2 and 3
  REQUIRE(order.groups.size() == 1);    // two blocks tell nothing apart
  CHECK(order.groups[0].first == 0);
  CHECK(order.groups[0].last == 2);
}

TEST_CASE("rank order: p values by the formula, corrected for all pairs", "[study]") {
  // Always in this order in 14 blocks: ranks 1 to 4, and an error of sqrt(20 / 84) = 0.488.
  const std::vector<std::vector<double>> blocks(14, {4.0, 3.0, 2.0, 1.0});
  const RankOrder order = RankOrderOf(blocks);
  REQUIRE(order.pairs.size() == 6);
  const auto p = [&](std::size_t better, std::size_t worse) {
    for (const RankOrder::Pair& pair : order.pairs)
      if (pair.better == better && pair.worse == worse) return pair.p;
    return -1.0;
  };
  const auto plain = [](double difference) {
    return std::erfc(difference / std::sqrt(20.0 / 84.0) / std::sqrt(2.0));
  };
  CHECK_THAT(p(0, 3), Catch::Matchers::WithinRel(6.0 * plain(3.0), 1e-12));
  CHECK_THAT(p(0, 2), Catch::Matchers::WithinRel(5.0 * plain(2.0), 1e-12));
  CHECK_THAT(p(1, 3), Catch::Matchers::WithinRel(5.0 * plain(2.0), 1e-12));  // Holm never falls
  CHECK_THAT(p(0, 1), Catch::Matchers::WithinRel(3.0 * plain(1.0), 1e-12));
  // Neighbours are 2.05 errors apart, p = 0.04, 0.12 after the correction.
  REQUIRE(order.groups.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(order.groups[i].first == i);
    CHECK(order.groups[i].last == i + 1);
  }
}

}  // namespace gaitsmith::shell::test
