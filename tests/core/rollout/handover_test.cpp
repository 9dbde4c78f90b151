// SPDX-License-Identifier: MIT
// Controllers scored from the states in which others leave the figure.
#include <array>
#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/document/joints.h"
#include "core/document/json.h"
#include "core/rollout/evaluator.h"
#include "tests/scene.h"

namespace gaitsmith::test {
TEST_CASE("handover: in place of a clip, a controller is scored as the composite shows it", "[evaluator]") {
  Document d = TwoClips();
  d.model = GENERATE(1, 2);
  CAPTURE(d.model);
  d.task.weights = {0.5f, -0.25f, 2.0f, 0.01f, 0.3f, 0.01f, 0.2f};
  d.search.in_place_of = 1;
  d.pushes = {{.step = 100, .impulse_x_ns = 4.0f}, {.step = 400, .endpoint = 1, .impulse_y_ns = 3.0f}};
  REQUIRE(Validate(d));
  const Problem problem = ProblemOf(d);
  CHECK(problem.task.duration_steps == 300);
  const Motion motion = Simulate(d);
  const double way = motion.At(530).x_m - motion.At(230).x_m;
  float highest = 0.0f;
  for (int frame = 230; frame <= 530; ++frame) highest = std::max(highest, motion.At(frame).y_m);
  for (const int lanes : Evaluator::kLaneCounts) {
    const std::vector<Genome> genomes(5, d.controllers[1].genes);
    const auto found = Evaluator(problem, lanes, false).Evaluate(genomes);
    CHECK(std::abs(static_cast<double>(found[4].terms.travel_m) - way) < 1e-5);
    CHECK(found[4].terms.max_cm_height_m == highest);
    CHECK(found[4].terms.start_height_m == motion.At(230).y_m);
    const double turns = std::abs(motion.At(530).turn_rad - motion.At(230).turn_rad) / 6.283185307179586;
    CHECK(std::abs(static_cast<double>(found[4].terms.rotations) - turns) < 1e-6);
  }
}

TEST_CASE("handover: a beginning of no length is the start", "[evaluator]") {
  Document d = TwoClips();
  d.model = GENERATE(1, 2);
  const Problem plain = ProblemOf(d);
  Problem begun = plain;
  begun.beginnings.emplace_back();
  for (const Controller& controller : d.controllers) {
    const std::vector<Genome> genomes = {controller.genes};
    const auto a = Evaluator(plain, true).Evaluate(genomes)[0];
    const auto b = Evaluator(begun, true).Evaluate(genomes)[0];
    CHECK(a.fitness == b.fitness);
    CHECK(a.trajectory_hash == b.trajectory_hash);
  }
}

TEST_CASE("handover: who takes over goes on bit by bit as if nothing had happened",
          "[evaluator][determinism]") {
  // A rule that always holds remembers nothing, so a new clip with the same one changes nothing.
  Document d;
  d.figure = ShippedFigure("mr-star-man");
  d.model = GENERATE(1, 2);
  SetJointStrength(GENERATE(0.0f, 0.4f, 5.0f), d);
  d.start = {.drop_height_m = 0.3f, .velocity_x_mps = 1.0f, .spin_radps = 1.5f};
  d.pushes = {{.step = 120, .endpoint = 1, .impulse_x_ns = 6.0f, .impulse_y_ns = 2.0f}};
  const std::vector<float> pose(static_cast<std::size_t>(d.figure.Joints()), 0.6f);
  d.controllers = {HoldPose(d.figure, pose, 0.1f)};
  d.senses = d.controllers[0].senses;
  d.rules = d.controllers[0].rules;
  d.timeline = {{.controller = 0, .start_step = 0}};
  d.duration_steps = 260;
  const Motion whole = Simulate(d);
  // In flight, while it lands, in the step of the push and after it.
  for (const int step : {1, 24, 35, 36, 37, 50, 120, 121, 199}) {
    CAPTURE(d.model, step);
    Document chain = d;
    chain.timeline.push_back({.controller = 0, .start_step = step});
    REQUIRE(Validate(chain));
    CHECK(HashText(Simulate(chain).Hash()) == HashText(whole.Hash()));
    chain.search.in_place_of = 1;
    for (const int lanes : Evaluator::kLaneCounts) {
      const std::vector<Genome> genomes(3, d.controllers[0].genes);
      const auto found = Evaluator(ProblemOf(chain), lanes, false).Evaluate(genomes);
      float highest = 0.0f;
      for (int frame = step; frame <= 260; ++frame) highest = std::max(highest, whole.At(frame).y_m);
      CHECK(found[2].terms.start_height_m == whole.At(step).y_m);
      CHECK(found[2].terms.max_cm_height_m == highest);
    }
  }
}

TEST_CASE("handover: who takes over from a void motion is void", "[evaluator]") {
  const auto find = DecodeJson(ReadFile("tests/adversary/finds/blow-to-one-end.json"));
  REQUIRE(find);
  for (const auto& [steps, is_void] : {std::pair(75, false), std::pair(77, true)}) {
    Problem problem = ProblemOf(*find);
    problem.beginnings = {{.controllers = find->controllers, .clips = {{}}, .steps = steps}};
    problem.task.duration_steps = 1;
    for (const int lanes : Evaluator::kLaneCounts) {
      const std::vector<Genome> genomes(3, find->controllers[0].genes);
      CHECK(Evaluator(problem, lanes, false).Evaluate(genomes)[2].terms.broke_physics == is_void);
    }
  }
}

TEST_CASE("handover: with several, the mean counts", "[evaluator]") {
  Document d = TwoClips();
  d.search.handovers = {{.controller = 1, .step = 140}, {.controller = 0, .step = 333}};
  d.task.weights.fill(0.01f);  // a term with weight 0 is not measured
  REQUIRE(Validate(d));
  const Problem all = ProblemOf(d);
  REQUIRE(all.beginnings.size() == 3);
  const std::vector<Genome> genomes = {d.controllers[0].genes, d.controllers[1].genes};
  const auto mean = Evaluator(all).Evaluate(genomes);
  using Value = std::pair<const char*, float (*)(const Evaluation&)>;
  const std::array<Value, 10> values = {{
      {"fitness", [](const Evaluation& e) { return e.fitness; }},
      {"travel", [](const Evaluation& e) { return e.terms.travel_m; }},
      {"start height", [](const Evaluation& e) { return e.terms.start_height_m; }},
      {"height", [](const Evaluation& e) { return e.terms.max_cm_height_m; }},
      {"slip", [](const Evaluation& e) { return e.terms.slip_sum_m; }},
      {"rotations", [](const Evaluation& e) { return e.terms.rotations; }},
      {"effort", [](const Evaluation& e) { return e.terms.effort_rad; }},
      {"upright", [](const Evaluation& e) { return e.terms.upright; }},
      {"smoothness", [](const Evaluation& e) { return e.terms.smoothness_radps2; }},
      {"head", [](const Evaluation& e) { return e.terms.head_height_m; }},
  }};
  std::array<std::array<double, 10>, 2> sums{};
  for (const Beginning& beginning : all.beginnings) {
    Problem one = all;
    one.beginnings = {beginning};
    const auto found = Evaluator(one).Evaluate(genomes);
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t v = 0; v < values.size(); ++v) {
        sums[i][v] += static_cast<double>(values[v].second(found[i]));
      }
    }
  }
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t v = 0; v < values.size(); ++v) {
      CAPTURE(values[v].first);
      const double expected = sums[i][v] / 3.0;
      CHECK(expected != 0.0);
      CHECK(std::abs(static_cast<double>(values[v].second(mean[i])) - expected) <
            1e-5 * std::max(1.0, std::abs(expected)));
    }
  }
}

TEST_CASE("handover: one void evaluation makes the mean void", "[evaluator]") {
  Evaluation sound, broken;
  sound.fitness = 3.0f;
  broken.fitness = kVoidScore;
  broken.terms.broke_physics = true;
  for (const std::size_t at : {0u, 1u, 2u}) {
    CAPTURE(at);
    Evaluation mean;
    for (int i = 0; i < 3; ++i) AddToMean(mean, static_cast<std::size_t>(i) == at ? broken : sound, i);
    CHECK(mean.fitness == kVoidScore);
    CHECK(mean.terms.broke_physics);
  }
}

TEST_CASE("handover: what a document cannot ask for", "[document]") {
  Document d = TwoClips();
  d.search.in_place_of = 2;
  CHECK(Validate(d).error().Sentence() == "search.in_place_of: there is no clip 2, the timeline has 2");
  d.search.in_place_of = 1;
  d.duration_steps = 200;
  CHECK(Validate(d).error().Sentence() == "search.in_place_of: the motion ends before clip 1 begins");
  d.duration_steps = 530;
  d.search.handovers = {{.controller = 0, .step = 10}};
  CHECK(Validate(d).error().where == "search.handovers");
  d.search.in_place_of = -1;
  CHECK(Validate(d));
  d.search.handovers[0].controller = 2;
  CHECK(Validate(d).error().where == "search.handovers[0].controller");
}

}  // namespace gaitsmith::test
