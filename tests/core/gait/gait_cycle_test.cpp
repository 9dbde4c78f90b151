// SPDX-License-Identifier: MIT
#include "core/gait/gait_cycle.h"

#include <catch_amalgamated.hpp>
#include <cmath>

#include "tests/core/gait/walker.h"

namespace gaitsmith::test {

TEST_CASE("likeness: one after a period, little in between, and less the more a motion changes", "[gait]") {
  const Motion walk = Walk({}, 500);
  const Likeness likeness(walk, 1, 499, LimbPairs());
  CHECK(likeness.After(80) > 0.999);
  CHECK(likeness.After(160) > 0.999);
  CHECK(likeness.After(40) < 0.0);
  CHECK(likeness.Liveliness() > 0.05);
  const Motion grows = Walk({.growth = 0.001}, 500);
  const double after = Likeness(grows, 1, 499, LimbPairs()).After(80);
  CHECK(after < 0.999);
  CHECK(after > 0.9);
}

TEST_CASE("cycle: its period is found, whole or not, once and not twice", "[gait]") {
  for (const double period : {37.0, 61.5, 80.0, 123.25, 211.7}) {
    INFO(period);
    const Motion walk = Walk({.period_frames = period}, 700);
    const auto cycle = FindCycle(walk, 1, 699, false);
    REQUIRE(cycle);
    CHECK(std::abs(cycle->frames - period) <= 0.051);
    CHECK(cycle->likeness > 0.99);
    CHECK(cycle->turns == 0);
    CHECK(cycle->gap_rods < 0.005);
    CHECK(cycle->PeriodS() == cycle->frames * static_cast<double>(kStep));
  }
}

TEST_CASE("cycle: whole turns are counted", "[gait]") {
  for (const int turns : {-1, 1, 2}) {
    const auto cycle = FindCycle(Walk({.turns_per_cycle = static_cast<double>(turns)}, 700), 1, 699, false);
    REQUIRE(cycle);
    CHECK(cycle->turns == turns);
    CHECK(std::abs(cycle->frames - 80.0) <= 0.051);
  }
}

TEST_CASE("cycle: half of it is enough where limbs take each other's part", "[gait]") {
  const auto half = FindCycle(Walk({}, 500), 1, 499, true);
  REQUIRE(half);
  CHECK(half->half);
  CHECK(std::abs(half->frames - 40.0) <= 0.051);
  CHECK(std::abs(half->PeriodS() - 0.8) <= 0.0011);
  // Who limps has no like halves.
  const auto limps = FindCycle(Walk({.limp = 2.0}, 500), 1, 499, true);
  CHECK_THAT(limps ? "even" : limps.error().what, Catch::Matchers::StartsWith("it does not repeat"));
  const Figure star = ShippedFigure("mr-star-man");
  const std::vector<float> pose(star.rods.size() - 1, 0.3f);
  const Controller held = HoldPose(star, pose, 0.1f);
  const Clip clip{0, 0};
  const Motion holds = MotionOf(star, {}, {}, {}, {&held, 1}, {&clip, 1}, 300);
  CHECK(FindCycle(holds, 1, 300, true).error().what ==
        "the figure has no two limbs that can take each other's part");
}

TEST_CASE("cycle: where there is none, numbers say why", "[gait]") {
  const auto why = [](const Motion& motion, int first, int last) {
    const auto cycle = FindCycle(motion, first, last, false);
    return cycle ? "a cycle of " + std::to_string(cycle->frames) : cycle.error().what;
  };
  const Figure rod = LyingRod();
  CHECK_THAT(why(MotionOf(rod, {}, {}, {}, {}, {}, 300), 1, 300),
             Catch::Matchers::StartsWith("the figure stands still"));
  CHECK_THAT(why(Walk({}, 500), 1, 25), Catch::Matchers::StartsWith("0.24 s are too short to repeat"));
  // A fall does not repeat.
  const Motion falls = MotionOf(rod, {}, {.drop_height_m = 90.0f, .spin_radps = 0.5f}, {}, {}, {}, 300);
  CHECK_THAT(why(falls, 1, 300), Catch::Matchers::StartsWith("it never becomes like itself again") ||
                                     Catch::Matchers::StartsWith("it does not repeat"));
  const Motion grows = Walk({.growth = 0.05}, 700);
  CHECK_THAT(why(grows, 1, 699), Catch::Matchers::StartsWith("it does not repeat"));
}

}  // namespace gaitsmith::test
