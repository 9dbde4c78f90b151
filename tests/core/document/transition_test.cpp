// SPDX-License-Identifier: MIT
// How well one controller takes over from another.
#include "core/document/transition.h"

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/document/binary.h"
#include "core/document/timeline_edit.h"
#include "core/rollout/evaluator.h"
#include "tests/scene.h"

namespace gaitsmith::test {
TEST_CASE("transition: a state of the usual motion is near it", "[timeline]") {
  const Document d = TwoClips();
  const Motion usual = UsualMotion(d, 1);
  const Nearness same = NearnessOf(usual, 123, usual);
  CHECK(same.distance == 0.0f);
  CHECK(same.frame == 123);
  const Motion composite = Simulate(d);
  const Nearness at_switch = NearnessOf(composite, 230, usual);
  CHECK(at_switch.distance > 0.05f);
  // Neither the position along the ground nor whole turns matter.
  Document moved = d;
  moved.timeline = {{.controller = 1, .start_step = 0}};
  CHECK(NearnessOf(Simulate(moved), 77, usual).distance == 0.0f);
}

TEST_CASE("transition: the nearness of a state equals an independent computation", "[timeline]") {
  const Document d = TwoClips();
  const Motion usual = UsualMotion(d, 1), motion = Simulate(d);
  const int joints = usual.Bones().joints;
  // Joint angles and rates, sine and cosine of the turn, height, velocity, and a small difference of each.
  const auto state_of = [&](const Motion& of, int frame) {
    std::vector<double> state;
    state.reserve(2 * static_cast<std::size_t>(joints) + 5);
    for (int j = 0; j < joints; ++j) state.push_back(static_cast<double>(of.AngleRad(frame, j)));
    for (int j = 0; j < joints; ++j) state.push_back(static_cast<double>(of.RateRadps(frame, j)));
    const Motion::Frame& f = of.At(frame);
    for (const double value :
         {std::sin(f.turn_rad), std::cos(f.turn_rad), static_cast<double>(f.y_m),
          static_cast<double>(f.velocity_x_mps), static_cast<double>(f.velocity_y_mps)}) {
      state.push_back(value);
    }
    return state;
  };
  std::vector<double> little(static_cast<std::size_t>(joints), 0.1);
  little.insert(little.end(), static_cast<std::size_t>(joints), 0.5);
  const double short_way = 0.05 * static_cast<double>(usual.Bones().longest_rod_m);
  little.insert(little.end(), {0.2, 0.2, short_way, 0.2, 0.2});
  std::vector<double> spread(little.size());
  for (std::size_t i = 0; i < spread.size(); ++i) {
    double mean = 0.0, variance = 0.0;
    for (int at = 0; at < usual.Frames(); ++at) mean += state_of(usual, at)[i] / usual.Frames();
    for (int at = 0; at < usual.Frames(); ++at) {
      variance += std::pow(state_of(usual, at)[i] - mean, 2.0) / usual.Frames();
    }
    spread[i] = std::max(little[i], std::sqrt(variance));
  }
  for (const int frame : {0, 60, 230, 400}) {
    CAPTURE(frame);
    const std::vector<double> here = state_of(motion, frame);
    double least = 1e30;
    for (int at = 0; at < usual.Frames(); ++at) {
      const std::vector<double> there = state_of(usual, at);
      double sum = 0.0;
      for (std::size_t i = 0; i < here.size(); ++i) sum += std::pow((here[i] - there[i]) / spread[i], 2.0);
      least = std::min(least, std::sqrt(sum / static_cast<double>(here.size())));
    }
    CHECK(std::abs(static_cast<double>(NearnessOf(motion, frame, usual).distance) - least) < 1e-4);
  }
}

TEST_CASE("transition map: each moment is what the composite would show", "[timeline]") {
  Document d = TwoClips();
  d.task.duration_steps = 150;
  d.task.kind = TaskKind::kTravel;
  d.task.weights[static_cast<std::size_t>(StyleTerm::kUpright)] = 2.0f;
  d.pushes = {{.step = 250, .endpoint = 0, .impulse_x_ns = 3.0f, .impulse_y_ns = 1.0f}};
  const Document request = TransitionRequest(d, 1);
  REQUIRE(Validate(request));
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
