// SPDX-License-Identifier: MIT
// How well one controller takes over from another.
#include "core/document/transition.h"

#include <algorithm>
#include <catch_amalgamated.hpp>

#include "core/document/binary.h"
#include "core/document/timeline_edit.h"
#include "core/rollout/evaluator.h"
#include "tests/scene.h"

namespace gaitsmith::test {
TEST_CASE("transition map: each moment is what the composite would show", "[timeline]") {
  Document d = TwoClips();
  d.model = GENERATE(1, 2);
  d.task.duration_steps = 150;
  d.task.kind = TaskKind::kTravel;
  d.task.weights[static_cast<std::size_t>(StyleTerm::kUpright)] = 2.0f;
  d.pushes = {{.step = 250, .endpoint = 0, .impulse_x_ns = 3.0f, .impulse_y_ns = 1.0f}};
  const Document request = TransitionRequest(d, 1);
  REQUIRE(Validate(request));
  CHECK(request.model == d.model);
  const TransitionMap map = TransitionMapOf(request);
  const std::vector<int> steps = TransitionSteps(d, 1);
  REQUIRE(map.Count() == static_cast<int>(steps.size()));
  CHECK(steps.front() == kShortestClip);
  CHECK(steps.back() == d.duration_steps - kShortestClip);
  const std::vector<int> order = CoarseFirst(map.Count());
  for (const int place : {0, 1, 9, map.Count() - 1}) {
    const int step = steps[static_cast<std::size_t>(order[static_cast<std::size_t>(place)])];
    Document composite = d;
    composite.timeline[1].start_step = step;
    composite.duration_steps = step + 150;
    composite.search.in_place_of = 1;
    const auto direct = Evaluator(ProblemOf(composite)).Evaluate(std::vector<Genome>{d.controllers[1].genes});
    CHECK(map.Scores(place, 1)[0] == direct[0].fitness);
  }
  d.pushes.clear();
  CHECK(map.UsualScore() ==
        Evaluator(ProblemOf(d)).Evaluate(std::vector<Genome>{d.controllers[1].genes})[0].fitness);
}

TEST_CASE("transition map: a controller that goes the other way is measured that way", "[timeline]") {
  Document d = TwoClips();
  const auto scores_with = [&](TaskKind kind) {
    d.task.kind = kind;
    const TransitionMap map = TransitionMapOf(TransitionRequest(d, 1));
    CHECK(map.UsualScore() > 0.0f);
    return map.Scores(0, 20);
  };
  CHECK(scores_with(TaskKind::kTravelLeft) == scores_with(TaskKind::kTravelRight));
}

TEST_CASE("transition map: the same however it is dealt out, coarse first", "[timeline]") {
  const TransitionMap map = TransitionMapOf(TransitionRequest(TwoClips(), 1));
  const std::vector<float> whole = map.Scores(0, map.Count());
  for (const int part : {1, 7, 16}) {
    std::vector<float> joined;
    for (int first = 0; first < map.Count(); first += part) {
      const std::vector<float> some = map.Scores(first, std::min(part, map.Count() - first));
      joined.insert(joined.end(), some.begin(), some.end());
    }
    CHECK(joined == whole);
  }
  for (const int count : {0, 1, 5, 16, 17, 100}) {
    std::vector<int> order = CoarseFirst(count);
    if (count == 100)
      CHECK(std::vector(order.begin(), order.begin() + 8) == std::vector{0, 16, 32, 48, 64, 80, 96, 8});
    std::ranges::sort(order);
    REQUIRE(order.size() == static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) CHECK(order[static_cast<std::size_t>(i)] == i);
  }
}

TEST_CASE("transition map: a request has what the map depends on, and nothing else", "[timeline]") {
  Document d = TwoClips();
  d.timeline.push_back({.controller = 0, .start_step = 450});
  const auto bytes = [&](int clip) { return EncodeBinary(TransitionRequest(d, clip)); };
  const auto before = bytes(1);
  REQUIRE(MoveSwitch(d, 1, 123));
  d.timeline[2].controller = 1;
  d.controllers[1].name = "renamed";
  d.title = "renamed";
  d.duration_steps += 100;
  d.search.seed = 9;
  CHECK(bytes(1) == before);
  CHECK(bytes(2) != before);
  d.timeline[2].start_step += 5;
  CHECK(bytes(1) != before);
  const auto strong = bytes(1);
  d.model = 2;
  CHECK(bytes(1) != strong);
  const auto limited = bytes(1);
  d.figure.rods[1].strength = 3.0f;
  CHECK(bytes(1) != limited);
  d.task.duration_steps = 3 * kLongestWatch;
  CHECK(TransitionRequest(d, 1).task.duration_steps == kLongestWatch);
  d.task.duration_steps = kLongestWatch - 1;
  CHECK(TransitionRequest(d, 1).task.duration_steps == kLongestWatch - 1);
  CHECK(TransitionSteps(d, 0).empty());
  CHECK(TransitionSteps(d, 3).empty());
}

TEST_CASE("transition map: scores beside the usual one", "[timeline]") {
  CHECK(ShareOfUsual(2.0f, 4.0f) == 0.5f);
  CHECK(ShareOfUsual(8.0f, 4.0f) == 2.0f);
  CHECK(ShareOfUsual(-1.0f, 4.0f) == -0.25f);
  CHECK(ShareOfUsual(-4.0f, -4.0f) == 1.0f);
  CHECK(ShareOfUsual(-6.0f, -4.0f) == 0.5f);
  CHECK(ShareOfUsual(kVoidScore, -4.0f) == kVoidScore);
  CHECK(ShareOfUsual(0.0f, 0.0f) == 1.0f);
  CHECK(ShareOfUsual(1.0f, kVoidScore) == 1.0f);
}

}  // namespace gaitsmith::test
