// SPDX-License-Identifier: MIT
#include "core/control/rule_edit.h"

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/control/sense_table.h"
#include "core/document/document.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

SenseSpec EightySevenSteps() {
  SenseSpec senses;
  senses.kind = SenseKind::kTimer;
  senses.period_steps = 87;
  return senses;
}

}  // namespace

TEST_CASE("genes: a gene's number, written back, is that gene", "[control][rule_edit]") {
  for (const auto& [low, high] :
       {std::pair{-2.5f, 2.5f}, {0.0f, 1.0f}, {kEdgeLow, kEdgeHigh}, {-0.7f, 0.0f}}) {
    CAPTURE(low, high);
    int wrong = 0;
    for (int gene = 0; gene <= kGeneMax; ++gene) {
      wrong += Encode(Decode(static_cast<Gene>(gene), low, high), low, high) != gene ? 1 : 0;
    }
    CHECK(wrong == 0);
  }
  SenseSpec senses;
  senses.tau_min_s = 0.07f;
  senses.tau_max_s = 1.3f;
  int wrong = 0;
  for (int gene = 0; gene <= kGeneMax; ++gene) {
    wrong += EncodeTau(DecodeTau(static_cast<Gene>(gene), senses), senses) != gene ? 1 : 0;
  }
  CHECK(wrong == 0);
}

TEST_CASE("genes: any number is written as the nearest, and none leaves its range", "[control][rule_edit]") {
  RandomStream random(3, 1, 4);
  for (int i = 0; i < 5000; ++i) {
    const auto value = static_cast<float>(-0.7 + 2.1 * random.Uniform());
    CAPTURE(value);
    const float found = Decode(Encode(value, -0.7f, 1.4f), -0.7f, 1.4f);
    CHECK(std::abs(found - value) <= 0.51f * 2.1f / 65535.0f);
  }
  CHECK(Encode(-9.0f, -0.7f, 1.4f) == 0);
  CHECK(Encode(9.0f, -0.7f, 1.4f) == kGeneMax);
  CHECK(Encode(0.3f, 0.3f, 0.3f) == 0);
  SenseSpec senses;
  CHECK(EncodeTau(0.001f, senses) == 0);
  CHECK(EncodeTau(50.0f, senses) == kGeneMax);
  senses.tau_max_s = senses.tau_min_s;
  CHECK(EncodeTau(0.4f, senses) == 0);
}

TEST_CASE("rule edit: what is set is read back, and every other gene keeps its bits",
          "[control][rule_edit]") {
  const Figure figure = ShippedFigure("horse");
  const int rods = figure.Rods();
  Controller controller = RandomController(figure, SenseSpec{}, 11);
  const Genome before = controller.genes;
  const BankShape shape = controller.Shape(rods).Bank();
  RuleEdit edit(controller, rods, 6);
  edit.SetTarget(3, 0.4f, -0.9f, 1.1f);
  edit.SetTau(0.37f);
  edit.SetInterval(5, 0.82f, -0.11f);  // in the wrong order
  edit.SetCares(7, false);
  CHECK(std::abs(TargetOf(controller, rods, 6, 3, -0.9f, 1.1f) - 0.4f) < 2e-5f);
  CHECK(std::abs(TauOf(controller, rods, 6) - 0.37f) < 2e-5f);
  const Stimulus set = StimulusOf(controller, rods, 6, 5);
  CHECK(set.cares);
  CHECK(std::abs(set.low + 0.11f) < 2e-5f);
  CHECK(std::abs(set.high - 0.82f) < 2e-5f);
  CHECK_FALSE(StimulusOf(controller, rods, 6, 7).cares);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool named = i == shape.Target(6, 3) || i == shape.Tau(6) || i == shape.Low(6, 5) ||
                       i == shape.High(6, 5) || i == shape.Low(6, 7) || i == shape.High(6, 7);
    CAPTURE(i);
    if (!named) CHECK(controller.genes[i] == before[i]);
  }
}

TEST_CASE("rule edit: an interval drawn to both ends is still cared about; only the switch forgets it",
          "[control][rule_edit]") {
  const Figure figure = ShippedFigure("inchworm");
  for (const SenseSpec& senses : {SenseSpec{}, EightySevenSteps()}) {
    Controller controller = RandomController(figure, senses, 5);
    RuleEdit edit(controller, figure.Rods(), 2);
    const auto [low, high] = EdgesOf(senses.kind);
    edit.SetInterval(0, low, high);
    CHECK(StimulusOf(controller, figure.Rods(), 2, 0).cares);
    edit.SetCares(0, false);
    CHECK_FALSE(StimulusOf(controller, figure.Rods(), 2, 0).cares);
    edit.SetCares(0, true);
    const Stimulus anew = StimulusOf(controller, figure.Rods(), 2, 0);
    CHECK(anew.cares);
    CHECK(std::abs(anew.high - anew.low - 0.5f * (high - low)) < 1e-4f);
    const Genome kept = controller.genes;
    edit.SetCares(0, true);  // a second time: no change
    CHECK(controller.genes == kept);
  }
}

TEST_CASE("rule edit: a copy alone changes no motion; deleting the copy brings the genes back",
          "[control][rule_edit]") {
  for (const SenseKind kind : {SenseKind::kPhysical, SenseKind::kTimer}) {
    Document document = StarManTravel(kind);
    document.duration_steps = 700;
    document.timeline = {{0, 0}};
    document.controllers = {RandomController(document.figure, document.senses, 8)};
    const std::uint64_t hash = Simulate(document).Hash();
    Controller& controller = document.controllers[0];
    const Controller before = controller;
    for (int rule = 0; rule < before.rules; ++rule) {
      CAPTURE(rule);
      CopyRule(controller, document.figure.Rods(), rule);
      REQUIRE(controller.rules == before.rules + 1);
      CHECK(Validate(document));
      CHECK(Simulate(document).Hash() == hash);
      DeleteRule(controller, document.figure.Rods(), rule);
      CHECK(controller.rules == before.rules);
      CHECK(controller.genes == before.genes);
    }
    // The first rule starts the motion, so without it the motion differs.
    DeleteRule(controller, document.figure.Rods(), 0);
    CHECK(Validate(document));
    CHECK(Simulate(document).Hash() != hash);
  }
}

TEST_CASE("senses: their scales turn what a controller feels into what the motion did",
          "[control][rule_edit]") {
  Document document = StarManTravel(SenseKind::kPhysical);
  document.duration_steps = 300;
  document.timeline = {{0, 0}};
  document.controllers = {RandomController(document.figure, document.senses, 4)};
  const Motion motion = Simulate(document);
  const Skeleton& bones = motion.Bones();
  const Ports& ports = motion.Connections();
  const auto felt = [&](int frame, int sense) {
    return ScaleOf(document.senses, ports, sense).Of(motion.Sense(frame, sense));
  };
  float greatest_force = 0.0f;
  for (int frame = 1; frame < motion.Frames(); frame += 7) {
    CAPTURE(frame);
    for (int j = 0; j < bones.joints; ++j)
      CHECK(std::abs(felt(frame, j) - motion.AngleRad(frame, j)) < 1e-5f);
    for (int k = 0; k < bones.endpoints; ++k) {
      const SenseScale scale = ScaleOf(document.senses, ports, bones.joints + k);
      const float force = std::min(motion.Force(frame, k).y, scale.at_one);
      greatest_force = std::max(greatest_force, force);
      CHECK(std::abs(felt(frame, bones.joints + k) - force) < 1e-4f * scale.at_one);
    }
    CHECK(std::abs(felt(frame, bones.joints + bones.endpoints) - motion.At(frame).y_m) < 1e-5f);
    CHECK(std::abs(felt(frame, bones.joints + bones.endpoints + 1) - motion.At(frame).velocity_y_mps) <
          1e-5f);
  }
  CHECK(greatest_force > 1.0f);
  CHECK(ScaleOf(EightySevenSteps(), ports, 0).Of(0.5f) == Catch::Approx(0.435));
}

}  // namespace gaitsmith::test
