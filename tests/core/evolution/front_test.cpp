// SPDX-License-Identifier: MIT
// Fronts of two aims, against their definition.
#include "core/evolution/front.h"

#include <catch_amalgamated.hpp>
#include <limits>

#include "core/numeric/random.h"

namespace gaitsmith::test {

namespace {

/// Fronts by their definition: those that none of the rest dominates, again and again.
std::vector<int> FrontsByDefinition(const std::vector<Aims>& aims) {
  std::vector<int> fronts(aims.size(), -1);
  for (int front = 0; std::ranges::find(fronts, -1) != fronts.end(); ++front) {
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < aims.size(); ++i) {
      if (fronts[i] >= 0) continue;
      bool dominated = false;
      for (std::size_t j = 0; j < aims.size(); ++j)
        dominated = dominated || (fronts[j] < 0 && Dominates(aims[j], aims[i]));
      if (!dominated) members.push_back(i);
    }
    for (const std::size_t i : members) fronts[i] = front;
  }
  return fronts;
}

}  // namespace

TEST_CASE("fronts: as they are defined, with ties, equals and void motions", "[search][front]") {
  for (std::uint64_t round = 0; round < 300; ++round) {
    RandomStream random(11, round, 0);
    const std::uint32_t steps = 1 + random.Below(round % 2 == 0 ? 6 : 1000);
    std::vector<Aims> aims(1 + random.Below(60));
    for (Aims& one : aims) {
      one = {static_cast<float>(random.Below(steps)), static_cast<float>(random.Below(steps))};
      constexpr float kVoid = -std::numeric_limits<float>::infinity();
      if (random.Chance(0.1)) one = {kVoid, kVoid};
    }
    CAPTURE(round, aims.size());
    REQUIRE(FrontsOf(aims) == FrontsByDefinition(aims));
  }
  CHECK(FrontsOf({}).empty());
}

TEST_CASE("crowding: the ends of a front are never crowded, between them both aims count",
          "[search][front]") {
  // Four of one front, in no order, and one behind them.
  const std::vector<Aims> aims = {{3.0f, 1.0f}, {0.0f, 10.0f}, {1.0f, 9.0f}, {10.0f, 0.0f}, {0.0f, 0.0f}};
  const std::vector<int> fronts = FrontsOf(aims);
  CHECK(fronts == std::vector<int>{0, 0, 0, 0, 1});
  const std::vector<double> crowding = CrowdingOf(aims, fronts);
  constexpr double kEnd = std::numeric_limits<double>::infinity();
  CHECK(crowding[1] == kEnd);
  CHECK(crowding[3] == kEnd);
  CHECK(crowding[4] == kEnd);
  CHECK_THAT(crowding[2], Catch::Matchers::WithinAbs(3.0 / 10.0 + 9.0 / 10.0, 1e-12));
  CHECK_THAT(crowding[0], Catch::Matchers::WithinAbs(9.0 / 10.0 + 9.0 / 10.0, 1e-12));
  // All alike: only the ends of the order are kept apart.
  const std::vector<Aims> alike(4, {1.0f, 1.0f});
  const std::vector<double> none = CrowdingOf(alike, FrontsOf(alike));
  CHECK(none == std::vector<double>{kEnd, 0.0, 0.0, kEnd});
}

}  // namespace gaitsmith::test
