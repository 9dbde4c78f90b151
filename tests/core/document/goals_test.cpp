// SPDX-License-Identifier: MIT
// The tests that a motion has to meet to do what a goal asks for.
#include "core/document/goals.h"

#include <catch_amalgamated.hpp>

namespace gaitsmith {
namespace {

constexpr float kSeconds = 8.0f;

/// One upright rod of 2 m: its size is 2 m.
Figure Pole() {
  Figure figure{.name = "Pole", .rods = {Rod{}}};
  figure.rods[0].length_m = 2.0f;
  figure.rods[0].rest_rad = 1.5707964f;
  return figure;
}

/// A motion of which only the distance is known.
Terms Travelling(float metres) {
  Terms terms;
  terms.travel_m = metres;
  return terms;
}

}  // namespace

TEST_CASE("goals: each test has the limit that the book states", "[core][goals]") {
  const Figure pole = Pole();
  CHECK_FALSE(Meets(Goal::kFar, pole, Travelling(3.99f), kSeconds));
  CHECK(Meets(Goal::kFar, pole, Travelling(4.01f), kSeconds));
  CHECK(Meets(Goal::kFar, pole, Travelling(-4.01f), kSeconds));
  CHECK_FALSE(Meets(Goal::kFar, pole, Travelling(4.01f), 2.0f * kSeconds));

  Terms jump;
  jump.start_height_m = 1.0f;
  jump.max_cm_height_m = 1.39f;
  CHECK_FALSE(Meets(Goal::kHighJump, pole, jump, kSeconds));
  jump.max_cm_height_m = 1.41f;
  CHECK(Meets(Goal::kHighJump, pole, jump, kSeconds));

  Terms turn;
  turn.rotations = 0.99f;
  CHECK_FALSE(Meets(Goal::kCartwheel, pole, turn, kSeconds));
  turn.rotations = 1.01f;
  CHECK(Meets(Goal::kCartwheel, pole, turn, kSeconds));

  Terms glide = Travelling(2.01f);
  glide.slip_sum_m = 2.0f;
  CHECK_FALSE(Meets(Goal::kGlide, pole, glide, kSeconds));
  glide.slip_sum_m = 2.02f;
  CHECK(Meets(Goal::kGlide, pole, glide, kSeconds));
  glide.travel_m = 1.99f;
  CHECK_FALSE(Meets(Goal::kGlide, pole, glide, kSeconds));

  Terms calm = Travelling(2.01f);
  calm.effort_rad = 7.99f;
  CHECK(Meets(Goal::kCalm, pole, calm, kSeconds));
  calm.effort_rad = 8.01f;
  CHECK_FALSE(Meets(Goal::kCalm, pole, calm, kSeconds));

  Terms head = Travelling(2.01f);
  head.upright = 0.81f;
  head.head_height_m = 1.61f;
  CHECK(Meets(Goal::kHeadUp, pole, head, kSeconds));
  head.head_height_m = 1.59f;
  CHECK_FALSE(Meets(Goal::kHeadUp, pole, head, kSeconds));
  head.head_height_m = 1.61f;
  head.upright = 0.79f;
  CHECK_FALSE(Meets(Goal::kHeadUp, pole, head, kSeconds));
}

TEST_CASE("goals: a motion that broke physics meets none", "[core][goals]") {
  Terms broken = Travelling(100.0f);
  broken.broke_physics = true;
  broken.rotations = 5.0f;
  broken.max_cm_height_m = 9.0f;
  for (int i = 0; i < kGoals; ++i) CHECK_FALSE(Meets(static_cast<Goal>(i), Pole(), broken, kSeconds));
}

}  // namespace gaitsmith
