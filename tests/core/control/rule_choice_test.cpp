// SPDX-License-Identifier: MIT
#include "core/control/rule_choice.h"

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/document/document.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

/// The depth by its definition, in double precision, without the bank.
double DepthByHand(const Controller& c, const BankShape& shape, int rule, const std::vector<float>& senses) {
  const double low_edge = c.senses.kind == SenseKind::kTimer ? 0.0 : -0.25;
  const double width = c.senses.kind == SenseKind::kTimer ? 1.0 : 1.5;
  double depth = 1.0;
  for (int sense = 0; sense < shape.senses; ++sense) {
    const double low = low_edge + width * c.genes[shape.Low(rule, sense)] / 65535.0;
    const double high = low_edge + width * c.genes[shape.High(rule, sense)] / 65535.0;
    if (c.genes[shape.Low(rule, sense)] == 0 && c.genes[shape.High(rule, sense)] == kGeneMax) continue;
    const double half = std::max(0.5 * (high - low), 0.5 * width / 65535.0);
    const double felt = static_cast<double>(senses[static_cast<std::size_t>(sense)]);
    depth = std::min(depth, 1.0 - std::abs(felt - 0.5 * (low + high)) / half);
  }
  return depth;
}

}  // namespace

TEST_CASE("choice: depths, winner and runner-up are those of the law by hand", "[control][rule_choice]") {
  const Figure figure = ShippedFigure("beryl-biped");
  RandomStream random(9, 2, 6);
  int held = 0, stayed = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    SenseSpec spec;
    spec.kind = seed % 4 == 0 ? SenseKind::kTimer : SenseKind::kPhysical;
    const Controller controller = RandomController(figure, spec, seed);
    const BankShape shape = controller.Shape(figure.Rods()).Bank();
    std::vector<float> senses(static_cast<std::size_t>(shape.senses));
    for (float& sense : senses) sense = static_cast<float>(random.Uniform());
    const int present = static_cast<int>(random.Below(10));
    const RuleChoice choice = ChoiceOf(controller, figure.Rods(), senses, present);

    std::vector<double> depth(static_cast<std::size_t>(shape.rules));
    for (int rule = 0; rule < shape.rules; ++rule)
      depth[static_cast<std::size_t>(rule)] = DepthByHand(controller, shape, rule, senses);
    const auto at = [&](int rule) { return depth[static_cast<std::size_t>(rule)]; };
    const auto best = static_cast<int>(std::ranges::max_element(depth) - depth.begin());
    // Cases that depend on rounding are skipped.
    std::vector<double> sorted = depth;
    std::ranges::sort(sorted);
    if (std::abs(at(best)) < 1e-5 || sorted[9] - sorted[8] < 1e-5) continue;
    CHECK(choice.holds == (at(best) >= 0.0));
    CHECK(choice.rule == (at(best) >= 0.0 ? best : present));
    ++(choice.holds ? held : stayed);
    for (int rule = 0; rule < shape.rules; ++rule) {
      const RuleStanding& standing = choice.standings[static_cast<std::size_t>(rule)];
      CHECK(std::abs(static_cast<double>(standing.Depth()) - at(rule)) < 1e-4 * (2.0 + std::abs(at(rule))));
      int cares = 0;
      for (int sense = 0; sense < shape.senses; ++sense) cares += shape.Cares(controller.genes, rule, sense);
      CHECK(standing.cares == cares);
      CHECK((standing.decisive_sense < 0) == (cares == 0));
    }
    REQUIRE(choice.runner_up != choice.rule);
    double second = -1e9;
    for (int rule = 0; rule < shape.rules; ++rule) {
      if (rule != choice.rule) second = std::max(second, at(rule));
    }
    CHECK(std::abs(at(choice.runner_up) - second) < 1e-5 * (2.0 + std::abs(second)));
  }
  CHECK(held > 50);
  CHECK(stayed > 20);
}

TEST_CASE("choice: of every frame of a motion it names the rule that acted", "[control][rule_choice]") {
  for (const SenseKind kind : {SenseKind::kPhysical, SenseKind::kTimer}) {
    Document document = StarManTravel(kind);
    document.duration_steps = 500;
    document.timeline = {{0, 0}};
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      CAPTURE(seed);
      document.controllers = {RandomController(document.figure, document.senses, seed)};
      const Motion motion = Simulate(document);
      const int count = SenseCount(kind, document.figure.Rods());
      int wrong = 0;
      for (int frame = 1; frame < motion.Frames(); ++frame) {
        std::vector<float> senses(static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i) senses[static_cast<std::size_t>(i)] = motion.Sense(frame, i);
        const RuleChoice choice =
            ChoiceOf(document.controllers[0], document.figure.Rods(), senses, motion.At(frame - 1).rule);
        wrong += choice.rule != motion.At(frame).rule ? 1 : 0;
      }
      CHECK(wrong == 0);
    }
  }
}

}  // namespace gaitsmith::test
