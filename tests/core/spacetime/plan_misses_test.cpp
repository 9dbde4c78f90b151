// SPDX-License-Identifier: MIT
// What of a plan cannot be met is named, and plans that can be met are not refused.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <string>

#include "core/document/json.h"
#include "core/numeric/random.h"
#include "core/spacetime/planner.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

Document LampJump() { return DecodeJson(ReadFile("examples/plans/lamp-jump.json")).value(); }

/// The jump of a lamp that nobody has tried: other limbs, masses, times and places.
Document TweakedJump(std::uint64_t seed) {
  RandomStream random(seed, 2, 1);
  const auto between = [&random](double low, double high) {
    return static_cast<float>(low + (high - low) * random.Uniform());
  };
  Document d = LampJump();
  for (Rod& rod : d.figure.rods) rod.mass_kg *= between(0.7, 1.4);
  for (Rod& rod : d.figure.rods)
    if (rod.parent >= 0) rod.length_m *= between(0.8, 1.2);
  const int up = 60 + static_cast<int>(random.Below(30)), down = up + 35 + static_cast<int>(random.Below(16));
  for (Stance& stance : d.plan.stances)
    (stance.first_step == 0 ? stance.last_step : stance.first_step) = stance.first_step == 0 ? up : down;
  d.plan.smoothness = between(0.01, 0.1);
  Keyframe& last = d.plan.keyframes.back();
  last.marks[0].x_m = between(0.1, 1.0);
  for (float& angle : last.pose_rad) angle = between(-0.2, 0.2);
  return d;
}

}  // namespace

TEST_CASE("of fifty tweaked jumps that can be made, at most one is not found", "[spacetime]") {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const PlanAnswer answer = SolvePlan(SceneOf(TweakedJump(seed)), {});
    found += answer.motion ? 1 : 0;
    if (!answer.motion)
      UNSCOPED_INFO("seed " << seed << ": "
                            << (answer.misses.empty() ? "nothing to blame"
                                                      : ErrorOf(answer.misses.front()).Sentence()));
  }
  CHECK(found >= 49);
}

TEST_CASE("what cannot be met is named in 19 of 20 corrupted plans", "[spacetime]") {
  int named = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Document d = TweakedJump(seed);
    RandomStream random(seed, 4, 1);
    PlanPart culprit{};
    Keyframe& last = d.plan.keyframes.back();
    switch (seed % 4) {
      case 0:  // a joint beyond its limit
        culprit = {PlanPart::Kind::kJoint, 0, static_cast<int>(random.Below(3))};
        last.pose_rad[static_cast<std::size_t>(culprit.which)] = 2.0f;
        break;
      case 1:  // a head higher than all limbs together, while the feet stand
        d.plan.keyframes.insert(d.plan.keyframes.begin(),
                                {.step = 30, .marks = {{.endpoint = 4, .axes = MarkAxes::kUp, .y_m = 2.5f}}});
        culprit = {PlanPart::Kind::kMarkY, 0, 0};
        break;
      case 2:  // the root turned, while it lies on the ground
        d.plan.keyframes.insert(d.plan.keyframes.begin(), {.step = 150, .turned = true, .turn_rad = 0.7f});
        culprit = {PlanPart::Kind::kTurn, 0, 0};
        break;
      default:  // the head far ahead of the feet
        d.plan.keyframes.insert(
            d.plan.keyframes.begin(),
            {.step = 20, .marks = {{.endpoint = 4, .axes = MarkAxes::kAlong, .x_m = 3.0f}}});
        culprit = {PlanPart::Kind::kMarkX, 0, 0};
    }
    const PlanAnswer answer = SolvePlan(SceneOf(d), {});
    CHECK_FALSE(answer.motion);
    const bool right = !answer.misses.empty() && answer.misses.front().part == culprit;
    named += right ? 1 : 0;
    if (!right)
      UNSCOPED_INFO(
          "seed " << seed << ": "
                  << (answer.misses.empty() ? "nothing" : ErrorOf(answer.misses.front()).Sentence()));
  }
  CHECK(named >= 19);
}

TEST_CASE("where nothing can be at rest, no wish is accused", "[spacetime]") {
  Document d = LampJump();
  d.start.drop_height_m = 1.0f;
  d.start.velocity_x_mps = 1.0f;
  d.plan.steps = 20;
  d.plan.stances.clear();
  d.plan.keyframes = {{.step = 10, .marks = {{.axes = MarkAxes::kUp, .y_m = 1.2f}}, .still = true}};
  REQUIRE(CheckScene(SceneOf(d)));
  const PlanAnswer answer = SolvePlan(SceneOf(d), {});
  CHECK_FALSE(answer.motion);
  CHECK(answer.misses.empty());
}

TEST_CASE("a plan that would take all memory is refused before it is tried", "[spacetime]") {
  Document d = LampJump();
  while (d.figure.rods.size() < kMaxRods)
    d.figure.rods.push_back({.length_m = 0.2f, .parent = static_cast<int>(d.figure.rods.size()) - 1});
  d.plan.steps = kMaxPlanSteps;
  d.plan.keyframes.clear();
  d.plan.stances.clear();
  for (int k = 0; k <= kMaxRods; ++k) d.plan.stances.push_back({k, 1, kMaxPlanSteps});
  REQUIRE(Validate(d));
  CHECK_FALSE(CheckScene(SceneOf(d)));
}

TEST_CASE("a cancelled solver returns no motion and names no miss", "[spacetime]") {
  const PlanAnswer answer = SolvePlan(SceneOf(LampJump()), {}, nullptr,
                                      [](const PlannedMotion&, int iteration) { return iteration < 5; });
  CHECK(answer.cancelled);
  CHECK_FALSE(answer.motion);
  CHECK(answer.misses.empty());
}

TEST_CASE("a miss is said in words", "[spacetime]") {
  CHECK(ErrorOf({{PlanPart::Kind::kMarkX, 2, 1}, 0.2345}).Sentence() ==
        "plan.keyframes[2].marks[1].x_m: cannot be met: the nearest motion misses it by 0.23 m");
  CHECK(ErrorOf({{PlanPart::Kind::kJoint, 0, 3}, 1.5}).Sentence() ==
        "plan.keyframes[0].pose[3]: cannot be met: the nearest motion misses it by 1.50 rad");
  CHECK(ErrorOf({{PlanPart::Kind::kStanceY, 4, 0}, 0.001}).Sentence() ==
        "plan.stances[4]: cannot be met: the nearest motion misses it by 0.01 m");
}

}  // namespace gaitsmith::test
