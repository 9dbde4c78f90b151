// SPDX-License-Identifier: MIT
#include "core/control/stimulus_response.h"

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/control/bank.h"
#include "core/rollout/evaluator.h"
#include "core/search/operators.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

/// A timer bank for a two-rod figure whose rules are active in the given intervals of the period.
struct TimerBank {
  SenseSpec senses;
  BankShape shape;
  Genome genes;
  explicit TimerBank(const std::vector<std::array<int, 2>>& intervals)
      : shape(static_cast<int>(intervals.size()), SenseKind::kTimer, 2) {
    senses.kind = SenseKind::kTimer;
    genes.assign(shape.Genes(), 30000);
    for (int rule = 0; rule < shape.rules; ++rule) {
      genes[shape.Low(rule, 0)] = static_cast<Gene>(intervals[static_cast<std::size_t>(rule)][0]);
      genes[shape.High(rule, 0)] = static_cast<Gene>(intervals[static_cast<std::size_t>(rule)][1]);
    }
  }
  [[nodiscard]] int Choose(float sense, int present) const {
    const std::span<const Gene> span(genes);
    const Ports ports = {.actuator_range = {{-1.0f, 1.0f}}, .contacts = 3};
    const Bank<1> bank(shape, senses, std::span(&span, 1), ports, kStep);
    SenseVector<1> values{};
    values[0][0] = sense;
    return bank.Choose(values, Lane<1>::I{present})[0];
  }
};

}  // namespace

TEST_CASE("rules: the deepest stimulus wins, ties go to the first, and the last rule stays", "[control]") {
  const TimerBank bank({{0, 20000}, {10000, 30000}, {10000, 30000}});
  CHECK(bank.Choose(10000.0f / 65535.0f, 2) == 0);  // the middle of rule 0, the border of rule 1
  CHECK(bank.Choose(20000.0f / 65535.0f, 0) == 1);  // the middle of rules 1 and 2
  CHECK(bank.Choose(15000.0f / 65535.0f, 2) <= 1);  // equally deep in all
  CHECK(bank.Choose(0.9f, 2) == 2);                 // in none of them: the present rule stays
  CHECK(bank.Choose(0.9f, 1) == 1);
}

TEST_CASE("timer: the table of choices says what the rules themselves say, at every phase", "[control]") {
  const Ports ports = {.actuator_range = {{-1.0f, 1.0f}}, .contacts = 3};
  for (const int period : {2, 7, 100, 12000}) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      CAPTURE(period, seed);
      SenseSpec senses;
      senses.kind = SenseKind::kTimer;
      senses.period_steps = period;
      const BankShape shape(10, SenseKind::kTimer, 2);
      RandomStream random(seed, 0, 0);
      Genome genes = RandomGenome(shape, senses, Variation{}, random);
      if (seed % 3 == 0) genes[shape.High(4, 0)] = genes[shape.Low(4, 0)];  // a point
      if (seed % 4 == 0) {                                                  // a rule that ignores the sense
        genes[shape.Low(7, 0)] = 0;
        genes[shape.High(7, 0)] = kGeneMax;
      }
      const std::span<const Gene> span(genes);
      const Bank<1> bank(shape, senses, std::span(&span, 1), ports, kStep);
      for (int phase = 0; phase < period; ++phase) {
        SenseVector<1> values{};
        values[0][0] = TimerSense(phase, period);
        if (bank.ChoiceAt(phase)[0] != bank.Choose(values, Lane<1>::I{-1})[0]) FAIL("phase " << phase);
      }
    }
  }
}

TEST_CASE("rules: a sense a rule does not care about never counts", "[control]") {
  // Rule 0 ignores the sense, so its depth is always the greatest possible.
  const TimerBank bank({{0, kGeneMax}, {0, 30000}});
  CHECK(bank.Choose(0.1f, 1) == 0);
  CHECK(bank.Choose(0.99f, 1) == 0);
}

TEST_CASE("rules: a stimulus of one point can still be hit", "[control]") {
  const TimerBank bank({{60000, 60000}, {0, 65000}});
  CHECK(bank.Choose(60000.0f / 65535.0f, 1) == 0);
  CHECK(bank.Choose(59000.0f / 65535.0f, 1) == 1);
}

TEST_CASE("genes: time constants are log-uniform over their range", "[control]") {
  SenseSpec senses;
  senses.tau_min_s = 0.1f;
  senses.tau_max_s = 0.9f;
  CHECK(DecodeTau(0, senses) == Catch::Approx(0.1f));
  CHECK(DecodeTau(kGeneMax, senses) == Catch::Approx(0.9f));
  CHECK(DecodeTau(32768, senses) == Catch::Approx(0.3f).epsilon(1e-4));
}

TEST_CASE("variation: children differ from their parents, keep order and care in proportion", "[control]") {
  const BankShape shape(10, SenseKind::kPhysical, 5);
  const SenseSpec senses;
  const Variation variation;
  RandomStream start(1, 0, 0);
  Genome genome = RandomGenome(shape, senses, variation, start);
  int cares = 0, total = 0;
  for (std::uint64_t i = 1; i <= 3000; ++i) {
    RandomStream random(1, 0, i);
    const Genome child = Perturb(genome, shape, senses, variation, random);
    REQUIRE(child != genome);
    for (int rule = 0; rule < shape.rules; ++rule) {
      for (int sense = 0; sense < shape.senses; ++sense, ++total) {
        REQUIRE(child[shape.Low(rule, sense)] <= child[shape.High(rule, sense)]);
        cares += shape.Cares(child, rule, sense) ? 1 : 0;
      }
    }
    genome = child;
  }
  // Drift without selection keeps the share of senses that rules use near that of the first generation.
  CHECK(static_cast<double>(cares) / total == Catch::Approx(0.2).margin(0.05));
}

TEST_CASE("variation: random rules do switch", "[control]") {
  const Figure figure = ShippedFigure("mr-star-man");
  SenseSpec timer;
  timer.kind = SenseKind::kTimer;
  for (const SenseSpec& senses : {SenseSpec{}, timer}) {
    int switches = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const Motion motion =
          MotionOf(figure, Environment{}, StartState{}, {},
                   std::vector{RandomController(figure, senses, seed)}, std::vector<Clip>{{0, 0}}, 500);
      for (int i = 1; i < motion.Frames(); ++i)
        switches += motion.At(i).rule != motion.At(i - 1).rule ? 1 : 0;
    }
    CHECK(switches / 200 >= 4);
  }
}

TEST_CASE("timer: resets at the switch and repeats with its period", "[control]") {
  const Figure figure = ShippedFigure("mr-star-man");
  SenseSpec timer;
  timer.kind = SenseKind::kTimer;
  timer.period_steps = 70;
  const std::vector<Controller> controllers = {RandomController(figure, timer, 8)};
  const Motion motion = MotionOf(figure, Environment{}, StartState{}, {}, controllers,
                                 std::vector<Clip>{{0, 0}, {0, 205}}, 500);
  for (int i = 141; i < 205; ++i) REQUIRE(motion.At(i).rule == motion.At(i - 70).rule);
  REQUIRE(motion.Sense(205, 0) == Catch::Approx(65.0f / 70.0f));
  REQUIRE(motion.Sense(206, 0) == Catch::Approx(1.0f / 70.0f));
}

TEST_CASE("lanes: a batch of one and a batch of any size give the same bits, for every lane count",
          "[determinism]") {
  for (const SenseKind kind : {SenseKind::kPhysical, SenseKind::kTimer}) {
    for (const char* name : {"mr-star-man", "beryl-biped", "horse"}) {
      Document document = StarManTravel(kind);
      document.figure = ShippedFigure(name);
      document.senses.tau_min_s = 0.07f;
      document.pushes = {{40, 1, 1.0f, 2.0f}};
      const Problem problem = ProblemOf(document);
      std::vector<Genome> genomes;
      genomes.reserve(23);
      for (std::uint64_t i = 0; i < 23; ++i) {
        genomes.push_back(RandomController(document.figure, document.senses, i).genes);
      }
      const auto alone = Evaluator(problem, 1, true).Evaluate(genomes);
      for (const int lanes : Evaluator::kLaneCounts) {
        const auto together = Evaluator(problem, lanes, true).Evaluate(genomes);
        for (std::size_t i = 0; i < genomes.size(); ++i) {
          CAPTURE(name, lanes, i);
          REQUIRE(together[i].trajectory_hash == alone[i].trajectory_hash);
          REQUIRE(together[i].fitness == alone[i].fitness);
          REQUIRE(together[i].terms.slip_sum_m == alone[i].terms.slip_sum_m);
        }
      }
      // The recorded motion equals the evaluated one.
      const Motion motion =
          MotionOf(document.figure, {}, {}, document.pushes,
                   std::vector{Controller{"", ControllerKind::kRules, document.senses, 10, genomes[3]}},
                   std::vector<Clip>{{0, 0}}, 500);
      REQUIRE(motion.Hash() == alone[3].trajectory_hash);
    }
  }
}

}  // namespace gaitsmith::test
