// SPDX-License-Identifier: MIT
// How well one controller takes over from another.
#include "core/document/transition.h"

#include <catch_amalgamated.hpp>

#include "core/physics/evaluator.h"
#include "tests/scene.h"

namespace gaitsmith::test {
namespace {

Document TwoClips() {
  Document d = StarManTravel(SenseKind::kPhysical);
  d.controllers = {RandomController(d.figure, d.senses, 5), RandomController(d.figure, d.senses, 6)};
  d.timeline = {{.controller = 0, .start_step = 0}, {.controller = 1, .start_step = 200}};
  d.duration_steps = 500;
  return d;
}

}  // namespace

TEST_CASE("transition: a state of the usual motion is near it", "[timeline]") {
  const Document d = TwoClips();
  const Motion usual = UsualMotion(d, 1);
  const Nearness same = NearnessOf(usual, 123, usual);
  CHECK(same.distance == 0.0f);
  CHECK(same.frame == 123);
  const Motion composite = Simulate(d);
  const Nearness at_switch = NearnessOf(composite, 200, usual);
  CHECK(at_switch.distance > 0.05f);
  // Where along the ground does not matter, nor do whole turns.
  Document moved = d;
  moved.timeline = {{.controller = 1, .start_step = 0}};
  CHECK(NearnessOf(Simulate(moved), 77, usual).distance == 0.0f);
}

TEST_CASE("transition map: each moment is what the composite would show", "[timeline]") {
  Document d = TwoClips();
  const TransitionMap map(d, 1, 25, 150);
  REQUIRE(map.Count() == 16);
  CHECK(map.StepOf(0) == 25);
  CHECK(map.StepOf(map.Count() - 1) == 400);
  for (const int index : {0, 5, 15}) {
    d.timeline[1].start_step = map.StepOf(index);
    d.duration_steps = map.StepOf(index) + 150;
    d.search.in_place_of = 1;
    const auto found = Evaluator(ProblemOf(d)).Evaluate(std::vector<Genome>{d.controllers[1].genes});
    CHECK(map.ScoreAt(index) == found[0].fitness);
  }
  d.search.in_place_of = -1;
  d.task.duration_steps = 150;
  CHECK(map.UsualScore() ==
        Evaluator(ProblemOf(d)).Evaluate(std::vector<Genome>{d.controllers[1].genes})[0].fitness);
}

TEST_CASE("transition map: a long motion ends the map", "[timeline]") {
  Document d = TwoClips();
  d.timeline[1].start_step = kMaxSteps - 10;
  d.duration_steps = kMaxSteps;
  const TransitionMap map(d, 1, 100, 50);
  CHECK(map.StepOf(map.Count() - 1) < kMaxSteps);
}

}  // namespace gaitsmith::test
