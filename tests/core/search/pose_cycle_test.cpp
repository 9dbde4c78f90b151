// SPDX-License-Identifier: MIT
// Pose cycles cycle, moves of rules touch what acts, and the search finds with 1,000 evaluations what hill
// climbing does not.
#include "core/document/json.h"
#include "core/search/evaluation_score.h"
#include "core/search/pose_cycle_form.h"
#include "core/search/rule_moves.h"
#include "tests/scene.h"
#include "tests/search_run.h"

namespace gaitsmith::test {
namespace {

Document Star() { return *DecodeJson(ReadFile("examples/problems/star-man-travel.json")); }

}  // namespace

TEST_CASE("pose cycles: the figure passes from pose to pose, and no further rule acts",
          "[search][pose-cycle]") {
  const Document star = Star();
  const Problem problem = ProblemOf(star);
  const BankShape bank = problem.Shape().Bank();
  const CycleForm form;
  // Two poses well within the joints' ranges, fast, with wide boxes.
  std::vector<double> point = {0.3, 0.7, 0.4, 0.6, 0.0, 0.8, 0.6, 0.3, 0.7, 0.4, 0.0, 0.8};
  REQUIRE(point.size() == DimensionsOf(form, bank));
  const Genome genes = CycleAt(form, point, bank, SenseKind::kPhysical);
  std::array<int, 2> acts{};
  for (const Sighting& sighting : SightingsOf(problem, genes, 100)) {
    REQUIRE(sighting.rule < 2);
    ++acts[static_cast<std::size_t>(sighting.rule)];
  }
  CHECK(acts[0] >= 20);
  CHECK(acts[1] >= 20);
  for (int rule = 2; rule < bank.rules; ++rule) CHECK(bank.Cares(genes, rule, 0));
}

TEST_CASE("pose cycles: with a timer the poses share the period, and the sequence repeats",
          "[search][pose-cycle]") {
  const BankShape bank(10, SenseKind::kTimer, 3);
  const CycleForm form{.poses = 3, .repeats = 3};
  RandomStream random(1, 2, 3);
  const Genome genes = CycleAt(form, DrawPoint(form, bank, random), bank, SenseKind::kTimer);
  CHECK(genes[bank.Low(0, 0)] == 0);
  CHECK(genes[bank.High(8, 0)] == kGeneMax);
  for (int rule = 1; rule < 9; ++rule) CHECK(genes[bank.Low(rule, 0)] == genes[bank.High(rule - 1, 0)]);
  for (int rule = 3; rule < 9; ++rule) {
    CAPTURE(rule);
    for (int joint = 0; joint < 2; ++joint)
      CHECK(genes[bank.Target(rule, joint)] == genes[bank.Target(rule - 3, joint)]);
    const int width = genes[bank.High(rule, 0)] - genes[bank.Low(rule, 0)];
    CHECK(std::abs(width - (genes[bank.High(rule - 3, 0)] - genes[bank.Low(rule - 3, 0)])) <= 1);
  }
}

TEST_CASE("pose cycles: forms fit every bank", "[search][pose-cycle]") {
  RandomStream random(4, 5, 6);
  for (int rules = 1; rules <= kMaxRules; ++rules) {
    for (const SenseKind senses : {SenseKind::kPhysical, SenseKind::kTimer}) {
      const BankShape bank(rules, senses, 2);
      for (int i = 0; i < 20; ++i) {
        const CycleForm form = DrawForm(bank, senses, random);
        REQUIRE(form.poses >= 1);
        REQUIRE(form.repeats >= 1);
        REQUIRE(form.poses * form.repeats <= rules);
        REQUIRE(CycleAt(form, DrawPoint(form, bank, random), bank, senses).size() == bank.Genes());
      }
    }
  }
}

TEST_CASE("sightings: the same senses and rules as the recorded motion", "[rollout][pose-cycle]") {
  Document star = Star();
  star.task.duration_steps = 300;
  const Problem problem = ProblemOf(star);
  RandomStream random(7, 8, 9);
  Controller controller{"c", star.kind, star.senses, star.rules, {}};
  controller.genes = RandomGenome(problem.Shape(), star.senses, Variation{}, random);
  star.controllers = {controller};
  star.timeline = {{0, 0}};
  star.duration_steps = 300;
  const Motion motion = Simulate(star);
  const std::vector<Sighting> sightings = SightingsOf(problem, controller.genes, 30);
  REQUIRE(sightings.size() == 30);
  for (int i = 0; i < 30; ++i) {
    CAPTURE(i);
    const Sighting& sighting = sightings[static_cast<std::size_t>(i)];
    CHECK(sighting.rule == motion.At(10 * (i + 1)).rule);
    for (int sense = 0; sense < static_cast<int>(sighting.senses.size()); ++sense) {
      const float felt = motion.Sense(10 * (i + 1), sense);
      CHECK(sighting.senses[static_cast<std::size_t>(sense)] == Encode(felt, kEdgeLow, kEdgeHigh));
    }
  }
}

TEST_CASE("moves of rules: idle rules change only when they are placed or silenced", "[search][pose-cycle]") {
  const Problem problem = ProblemOf(Star());
  const BankShape bank = problem.Shape().Bank();
  RandomStream random(1, 1, 1);
  const Genome parent =
      CycleAt(CycleForm{}, DrawPoint(CycleForm{}, bank, random), bank, SenseKind::kPhysical);
  const std::vector<Sighting> sightings = SightingsOf(problem, parent, 32);
  int acting = 0, placed = 0;
  for (int i = 0; i < 2000; ++i) {
    const Genome child = MoveRules(parent, sightings, bank, random);
    REQUIRE(child != parent);
    for (int rule = 0; rule < bank.rules; ++rule) {
      const std::size_t first = bank.Low(rule, 0), size = static_cast<std::size_t>(bank.GenesPerRule());
      const bool changed =
          !std::ranges::equal(std::span(child).subspan(first, size), std::span(parent).subspan(first, size));
      (rule < 2 ? acting : placed) += changed ? 1 : 0;
      for (int sense = 0; sense < bank.senses; ++sense)
        REQUIRE(child[bank.Low(rule, sense)] <= child[bank.High(rule, sense)]);
    }
  }
  CHECK(acting > 1500);
  CHECK(placed > 200);
  CHECK(placed < 800);
}

TEST_CASE("pose cycle: with 1,000 evaluations further than hill climbing with the same",
          "[search][pose-cycle]") {
  int wins = 0;
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    Document star = Star();
    star.search.seed = seed;
    star.search.evaluations = 1000;
    const float climbed = RunSearchOf(star).fitness;
    star.search.algorithm = Algorithm::kPoseCycle;
    wins += RunSearchOf(star).fitness > climbed ? 1 : 0;
  }
  CHECK(wins >= 7);
}

TEST_CASE("pose cycle: the climb may go down, but not below the worst of its last 50 parents",
          "[search][pose-cycle]") {
  Document star = Star();
  star.search.algorithm = Algorithm::kPoseCycle;
  star.search.evaluations = 3000;
  const auto search = MakeSearch(star.search, SpaceOf(star));
  const Evaluator evaluator(ProblemOf(star));
  std::vector<float> parents;  // after each generation of the climb
  while (!search->Done()) {
    std::vector<Score> scores;
    for (const Evaluation& one : evaluator.Evaluate(search->Ask(4))) scores.push_back(ScoreOf(one));
    search->Tell(scores);
    // The race has more members than one.
    if (const auto fitness = search->PopulationFitness(); fitness.size() == 1) parents.push_back(fitness[0]);
  }
  REQUIRE(parents.size() > 200);
  int downs = 0;
  for (std::size_t i = 1; i < parents.size(); ++i) downs += parents[i] < parents[i - 1] ? 1 : 0;
  CHECK(downs > 20);
  for (std::size_t i = 50; i < parents.size(); ++i)
    REQUIRE(parents[i] >= std::ranges::min(std::span(parents).subspan(i - 50, 50)));
  CHECK(search->BestFitness() >= std::ranges::max(parents));
}

TEST_CASE("pose cycle: works on networks, a single rod, one rule, and from a given start",
          "[search][pose-cycle]") {
  Document star = Star();
  star.search.algorithm = Algorithm::kPoseCycle;
  star.search.evaluations = 300;
  star.task.duration_steps = 100;
  const Outcome found = RunSearchOf(star);
  CHECK(found.scored == 300);
  star.controllers = {{"found", star.kind, star.senses, star.rules, found.best}};
  star.search.start = 0;
  const Outcome refined = RunSearchOf(star);
  CHECK(refined.curve.front().best == found.fitness);
  CHECK(refined.fitness >= found.fitness);

  Document network = Star();
  network.search = star.search;
  network.search.start = -1;
  network.kind = ControllerKind::kNetwork;
  network.task.duration_steps = 100;
  CHECK(RunSearchOf(network).fitness > 0.0f);
  Document one_rule = network;
  one_rule.kind = ControllerKind::kRules;
  one_rule.rules = 1;
  CHECK(RunSearchOf(one_rule).scored == 300);
  Document rod = one_rule;
  rod.figure = {"Rod", {{}}};
  rod.rules = 4;
  CHECK(RunSearchOf(rod).scored == 300);
}

}  // namespace gaitsmith::test
