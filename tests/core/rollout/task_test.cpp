// SPDX-License-Identifier: MIT
#include "core/rollout/task.h"

#include <catch_amalgamated.hpp>
#include <cmath>
#include <limits>

#include "core/rollout/motion.h"
#include "tests/scene.h"

namespace gaitsmith::test {

TEST_CASE("fitness: primary term plus weighted style terms", "[task]") {
  Task task;
  task.weights = {0.5f, 2.0f, -3.0f};
  Terms terms;
  terms.travel_m = -4.25f;
  terms.max_cm_height_m = 1.5f;
  terms.start_height_m = 0.75f;
  terms.slip_sum_m = 0.25f;
  terms.rotations = 1.25f;
  const float style = 0.75f + 0.5f - 3.75f;
  CHECK(Fitness(task, terms) == Catch::Approx(4.25f + style));
  task.kind = TaskKind::kTravelRight;
  CHECK(Fitness(task, terms) == Catch::Approx(-4.25f + style));
  task.kind = TaskKind::kTravelLeft;
  CHECK(Fitness(task, terms) == Catch::Approx(4.25f + style));
  task.kind = TaskKind::kJump;
  CHECK(Fitness(task, terms) == Catch::Approx(0.75f + style));
}

TEST_CASE("fitness: a motion that broke physics is the worst, never the best", "[task]") {
  Task task;
  Terms broken;
  broken.travel_m = 1e6f;
  broken.broke_physics = true;
  CHECK(Fitness(task, broken) == kVoidScore);
  broken.broke_physics = false;
  broken.travel_m = std::numeric_limits<float>::quiet_NaN();
  CHECK(Fitness(task, broken) == kVoidScore);
}

TEST_CASE("guard: spinning faster than the step resolves is void", "[task]") {
  StartState start;
  start.drop_height_m = 50.0f;
  start.spin_radps = 40.0f;
  const Figure figure = ShippedFigure("mr-star-man");
  const Motion slow = MotionOf(figure, Environment{}, start, {}, {}, {}, 20);
  CHECK(!slow.TermsAt(20).broke_physics);
  // Pushed at an endpoint until it turns at more than 50 rad/s.
  const std::vector<Push> pushes = {{0, 1, -60.0f, 0.0f}};
  const Motion fast = MotionOf(figure, Environment{}, start, pushes, {}, {}, 20);
  CHECK(fast.TermsAt(20).broke_physics);
}

TEST_CASE("terms: what a thrown star does is measured", "[task]") {
  StartState start;
  start.drop_height_m = 2.0f;
  start.velocity_y_mps = 5.0f;
  start.velocity_x_mps = -1.5f;
  start.spin_radps = 6.2831853f;
  const Motion motion = MotionOf(ShippedFigure("mr-star-man"), Environment{}, start, {}, {}, {}, 100);
  const Terms& terms = motion.TermsAt(100);
  CHECK(terms.travel_m == Catch::Approx(-1.5f).epsilon(1e-4));
  CHECK(terms.rotations == Catch::Approx(1.0f).epsilon(1e-4));
  CHECK(terms.slip_sum_m == 0.0f);
  CHECK(terms.max_cm_height_m - terms.start_height_m == Catch::Approx(25.0f / 19.6f).epsilon(1e-3));
}

TEST_CASE("terms: slip is the path of loaded endpoints", "[task]") {
  StartState start;
  start.velocity_x_mps = 2.0f;
  const Motion motion = MotionOf(LyingRod(), Environment{}, start, {}, {}, {}, 200);
  // Both ends slide together, from the second loaded step on.
  const float path = static_cast<float>(motion.At(200).x_m);
  CHECK(motion.TermsAt(200).slip_sum_m == Catch::Approx(2.0f * path).margin(2.0f * 0.02f * 2.0f));
}

}  // namespace gaitsmith::test
