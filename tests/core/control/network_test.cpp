// SPDX-License-Identifier: MIT
// Checks sensor-actuator networks against their sources, with handmade networks whose behaviour is known.
#include "core/control/network.h"

#include <catch_amalgamated.hpp>

#include "core/document/binary.h"
#include "core/document/json.h"
#include "core/rollout/evaluator.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

constexpr int kRods = 3;

/// One hidden node, no weights, all delays and time constants from the given gene, targets from least to
/// greatest.
Genome Quiet(const NetworkShape& shape, Gene delay) {
  Genome genes(shape.Genes(), 32767);  // weights: just below 0
  for (int node = 0; node < shape.Nodes(); ++node) {
    genes[shape.Delay(node)] = delay;
    if (!shape.IsActuator(node)) continue;
    genes[shape.Threshold(node)] = 0;
    genes[shape.TargetEmpty(node)] = 0;
    genes[shape.TargetFull(node)] = kGeneMax;
    genes[shape.Tau(node)] = 0;
  }
  return genes;
}

/// One network alone, with inputs set by the test.
struct Bench {
  NetworkShape shape{1, kRods};
  SenseSpec senses;
  std::vector<std::array<float, 2>> limits = {{-1.0f, 1.0f}, {-0.5f, 2.0f}};
  Genome genes = Quiet(shape, 0);  // the least delay: tau_min_s
  NetworkState<1> state;
  ActuatorTargets<1> targets{};

  [[nodiscard]] Network<1> Build() const {
    const std::span<const Gene> span(genes);
    return {shape, senses, std::span(&span, 1), limits, kStep};
  }
  void Advance(const Network<1>& network, std::array<float, 2> angles, std::array<float, 4> pushes) {
    using F = Lane<1>::F;
    const std::array<F, 2> angle = {F{angles[0]}, F{angles[1]}};
    const std::array<F, 4> push = {F{pushes[0]}, F{pushes[1]}, F{pushes[2]}, F{pushes[3]}};
    network.Advance(angle, push, state, targets);
  }
};

}  // namespace

TEST_CASE(
    "network: a node turns on when it has charged for its delay, and off when it has discharged for as long",
    "[control]") {
  Bench bench;
  bench.genes[bench.shape.Weight(0, 2)] = kGeneMax;  // touch 3 excites the hidden node
  const Network<1> network = bench.Build();
  network.Begin(bench.state, bench.targets);
  const auto output = [&] {
    return bench.state.input[static_cast<std::size_t>(bench.shape.Inputs()) - 1][0];
  };
  constexpr int kDelaySteps = 15;  // tau_min_s = 0.15 s
  int on = 0, off = 0;
  for (int step = 1; step <= 40; ++step) {
    bench.Advance(network, {-2.0f, -2.0f}, {0.0f, 0.0f, 1.0f, 0.0f});
    if (on == 0 && output() == 1.0f) on = step;
  }
  for (int step = 1; step <= 40; ++step) {
    bench.Advance(network, {-2.0f, -2.0f}, {1.0f, 1.0f, 0.0f, 1.0f});
    if (off == 0 && output() == 0.0f) off = step;
  }
  // The sum of the charges per step may round to just below 1.
  CHECK((on == kDelaySteps || on == kDelaySteps + 1));
  CHECK((off == kDelaySteps || off == kDelaySteps + 1));
}

TEST_CASE("network: a short touch does not turn a node, for it must fill up first", "[control]") {
  Bench bench;
  bench.genes[bench.shape.Weight(0, 0)] = kGeneMax;
  const Network<1> network = bench.Build();
  network.Begin(bench.state, bench.targets);
  for (int step = 0; step < 200; ++step) {
    // On for ten steps of every twenty: it charges as much as it discharges, and is never full.
    bench.Advance(network, {-2.0f, -2.0f}, {step % 20 < 10 ? 1.0f : 0.0f, 0.0f, 0.0f, 0.0f});
    REQUIRE(bench.state.input[static_cast<std::size_t>(bench.shape.Inputs()) - 1][0] == 0.0f);
  }
}

TEST_CASE("network: an actuator moves its target from one end to the other in its delay", "[control]") {
  Bench bench;
  const int actuator = bench.shape.hidden + 1;                                // of joint 2, [-0.5, 2] rad
  bench.genes[bench.shape.Weight(actuator, bench.shape.touches)] = kGeneMax;  // angle 1
  const Network<1> network = bench.Build();
  network.Begin(bench.state, bench.targets);
  CHECK(bench.targets.target[1][0] == -0.5f);
  // Threshold at the least angle, -1 rad: at -0.9 the sensor is on.
  for (int step = 1; step <= 15; ++step) {
    bench.Advance(network, {-0.9f, 0.0f}, {});
    const float expected = -0.5f + 2.5f * static_cast<float>(step) / 15.0f;
    REQUIRE(std::abs(bench.targets.target[1][0] - expected) < 1e-5f);
  }
  CHECK(bench.targets.target[0][0] == -1.0f);
  for (int step = 0; step < 100; ++step) bench.Advance(network, {-1.1f, 0.0f}, {});
  CHECK(bench.targets.target[1][0] == -0.5f);
}

TEST_CASE("network: a node that inhibits itself and is excited for ever swings in twice its delay",
          "[control]") {
  Bench bench;
  bench.genes[bench.shape.Weight(0, bench.shape.touches)] = 49151;   // angle 1: +1
  bench.genes[bench.shape.Weight(0, bench.shape.Inputs() - 1)] = 0;  // itself: -2
  const Network<1> network = bench.Build();
  network.Begin(bench.state, bench.targets);
  std::vector<int> turned_on;
  float before = 0.0f;
  for (int step = 0; step < 400; ++step) {
    bench.Advance(network, {0.0f, 0.0f}, {});
    const float now = bench.state.input[static_cast<std::size_t>(bench.shape.Inputs()) - 1][0];
    if (now > before) turned_on.push_back(step);
    before = now;
  }
  REQUIRE(turned_on.size() >= 10);
  for (std::size_t i = 1; i < turned_on.size(); ++i) {
    const int period = turned_on[i] - turned_on[i - 1];
    CAPTURE(i);
    CHECK((period >= 30 && period <= 32));
  }
}

TEST_CASE("network: neighbours do not change a motion's bits, and the recorded motion is the evaluated one",
          "[physics][control]") {
  Document document = StarManTravel(SenseKind::kPhysical);
  document.kind = ControllerKind::kNetwork;
  document.rules = 7;
  const Problem problem = ProblemOf(document);
  std::vector<Genome> genomes;
  for (std::uint64_t i = 0; i < 9; ++i) {
    RandomStream random(i, 3, 0);
    genomes.push_back(RandomGenome(problem.Shape(), problem.senses, Variation{}, random));
  }
  const auto alone = Evaluator(problem, 1, true).Evaluate(genomes);
  for (const int lanes : {2, 4, 8, 16}) {
    const auto together = Evaluator(problem, lanes, true).Evaluate(genomes);
    for (std::size_t i = 0; i < genomes.size(); ++i) {
      CAPTURE(lanes, i);
      REQUIRE(together[i].trajectory_hash == alone[i].trajectory_hash);
      REQUIRE(together[i].fitness == alone[i].fitness);
    }
  }
  for (std::size_t i = 0; i < genomes.size(); ++i) {
    const Controller controller{"", ControllerKind::kNetwork, document.senses, 7, genomes[i]};
    const Motion motion = MotionOf(document.figure, {}, {}, document.pushes, std::vector{controller},
                                   std::vector<Clip>{{0, 0}}, document.task.duration_steps);
    REQUIRE(motion.Hash() == alone[i].trajectory_hash);
  }
}

TEST_CASE("network: a document carries it in JSON and in a link, and says what does not fit", "[document]") {
  Document document = StarManTravel(SenseKind::kPhysical);
  const ControllerShape shape(ControllerKind::kNetwork, 6, SenseKind::kPhysical, document.figure.Rods());
  RandomStream random(1, 2, 3);
  document.controllers = {{"net", ControllerKind::kNetwork, document.senses, 6,
                           RandomGenome(shape, document.senses, Variation{}, random)}};
  document.timeline = {{0, 0}};
  const auto bytes = EncodeBinary(document);
  CHECK(bytes[0] == 2);
  const auto from_bytes = DecodeBinary(bytes);
  REQUIRE(from_bytes);
  CHECK(from_bytes->controllers[0].genes == document.controllers[0].genes);
  const auto from_json = DecodeJson(EncodeJson(document));
  REQUIRE(from_json);
  CHECK(EncodeBinary(*from_json) == bytes);

  const auto fault = [&](auto edit) {
    Document changed = document;
    edit(changed);
    const auto valid = Validate(changed);
    return valid ? std::string("valid") : valid.error().Sentence();
  };
  CHECK(fault([](Document& d) { d.controllers[0].senses.kind = SenseKind::kTimer; }) ==
        "controllers[0].kind: a network has physical senses, not a timer");
  CHECK(fault([](Document& d) {
          d.kind = ControllerKind::kNetwork;
          d.senses.kind = SenseKind::kTimer;
        }) == "kind: a network has physical senses, not a timer");
  CHECK(fault([](Document& d) {
          d.controllers[0].genes.pop_back();
        }).starts_with("controllers[0].rules: is for another figure"));

  std::string json = EncodeJson(document);
  const auto at = json.find("\"delay\"");
  REQUIRE(at != std::string::npos);
  json.replace(at, 7, "\"delai\"");
  const auto refused = DecodeJson(json);
  REQUIRE(!refused);
  CHECK(refused.error().Sentence() == "controllers[0].nodes[0].delay: is missing");
}

TEST_CASE("network: inputs are named by what they are, from one", "[network]") {
  const NetworkShape shape(2, 3);  // two hidden nodes; three rods have four endpoints and two joints
  std::vector<std::string> names;
  names.reserve(static_cast<std::size_t>(shape.Inputs()));
  for (int input = 0; input < shape.Inputs(); ++input) names.push_back(InputName(shape, input));
  CHECK(names == std::vector<std::string>{"touch 1", "touch 2", "touch 3", "touch 4", "angle 1", "angle 2",
                                          "node 1", "node 2"});
}

}  // namespace gaitsmith::test
