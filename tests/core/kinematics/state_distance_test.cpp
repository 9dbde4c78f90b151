// SPDX-License-Identifier: MIT
#include "core/kinematics/state_distance.h"

#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/document/document.h"
#include "tests/scene.h"

namespace gaitsmith::test {

TEST_CASE("state distance: none from a motion's own states, and the place does not count", "[distance]") {
  Document d = StarManTravel(SenseKind::kPhysical);
  d.controllers = {RandomController(d.figure, d.senses, 3)};
  d.timeline = {{0, 0}};
  d.duration_steps = 300;
  const Motion motion = Simulate(d);
  for (const int frame : {50, 120, 300}) CHECK(StateDistance(motion, frame, motion, 50) == 0.0);
  CHECK(StateDistance(motion, 40, motion, 50) > 0.0);
}

TEST_CASE("state distance: falling rods against the closed form", "[distance]") {
  // Free fall without joints: five numbers, of which only the height and the two velocities differ.
  const Figure rod = LyingRod();
  const double l = 1.3, t = std::sqrt(l / 9.8);
  const auto fall = [&](float speed) {
    StartState start{.drop_height_m = 50.0f, .velocity_x_mps = speed};
    return MotionOf(rod, {}, start, {}, {}, {}, 100);
  };
  const Motion still = fall(0.0f), thrown = fall(2.0f);
  // At the same moment they differ by 2 m/s alone. A moment earlier or later is further away.
  CHECK(std::abs(StateDistance(thrown, 60, still, 1) - std::sqrt(std::pow(2.0 * t / l, 2) / 5.0)) < 1e-6);
  // Only the last frame: one tenth of a second apart.
  const double v = 9.8 * 0.1 * t / l, h = 9.8 * (1.0 - 0.81) / 2.0 / l;
  CHECK(std::abs(StateDistance(still, 90, still, 100) - std::sqrt((v * v + h * h) / 5.0)) < 1e-3);
}

TEST_CASE("state distance: whole turns do not count", "[distance]") {
  const Figure rod = LyingRod();
  StartState start{.drop_height_m = 50.0f, .spin_radps = 12.566371f};  // a turn in half a second
  const Motion spins = MotionOf(rod, {.gravity_mps2 = 0.0f}, start, {}, {}, {}, 120);
  CHECK(StateDistance(spins, 20, spins, 70) < 1e-3);
  CHECK(StateDistance(spins, 45, spins, 120) > 1.0);
}

}  // namespace gaitsmith::test
