// SPDX-License-Identifier: MIT
// Controllers scored in several worlds, and joints that follow late.
#include <catch_amalgamated.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "core/document/trial_worlds.h"
#include "core/physics/figure_plant.h"
#include "core/physics/mechanism.h"
#include "core/physics/trajectory_hash.h"
#include "core/rollout/evaluator.h"
#include "core/rollout/rollout.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

Document InWorlds(int worlds, int model) {
  Document d = TwoClips();
  d.model = model;
  d.search.worlds = worlds;
  d.search.finest_step = FinestStep::kHalf;
  d.task.weights = {0.5f, -0.25f, 2.0f, 0.01f, 0.3f, 0.01f, 0.2f};
  REQUIRE(Validate(d));
  return d;
}

}  // namespace

TEST_CASE("worlds: the score is the mean of those in each world, whatever the number of lanes",
          "[evaluator]") {
  const Document d = InWorlds(4, GENERATE(1, 2));
  const Problem problem = ProblemOf(d);
  REQUIRE(problem.worlds.size() == 3);
  const std::vector<Genome> genomes{d.controllers[0].genes, d.controllers[1].genes};
  std::vector<std::vector<Evaluation>> each{Evaluator(problem.In({}), true).Evaluate(genomes)};
  for (const TrialWorld& world : problem.worlds)
    each.push_back(Evaluator(problem.In(world), false).Evaluate(genomes));
  for (const int lanes : Evaluator::kLaneCounts) {
    const auto found = Evaluator(problem, lanes, true).Evaluate(genomes);
    for (std::size_t i = 0; i < genomes.size(); ++i) {
      double fitness = 0.0, travel = 0.0;
      for (const auto& scored : each) {
        fitness += static_cast<double>(scored[i].fitness) / 4.0;
        travel += static_cast<double>(scored[i].terms.travel_m) / 4.0;
      }
      CHECK(static_cast<double>(found[i].fitness) == Catch::Approx(fitness).epsilon(1e-5));
      CHECK(static_cast<double>(found[i].terms.travel_m) == Catch::Approx(travel).epsilon(1e-5));
      CHECK(found[i].trajectory_hash == each[0][i].trajectory_hash);
    }
  }
}

TEST_CASE("worlds: one world is the document's own, to the bit", "[evaluator]") {
  const Document d = InWorlds(1, 2);
  Document without = d;
  without.search = {};
  CHECK(ProblemOf(d).worlds.empty());
  const std::vector<Genome> genomes{d.controllers[0].genes};
  CHECK(Evaluator(ProblemOf(d), true).Evaluate(genomes)[0].fitness ==
        Evaluator(ProblemOf(without), true).Evaluate(genomes)[0].fitness);
}

TEST_CASE("worlds: what breaks physics in one of them is void") {
  Document d = InWorlds(1, 1);
  Problem problem = ProblemOf(d);
  TrialWorld wild;
  wild.masses.assign(static_cast<std::size_t>(d.figure.Rods()), 1.0f);
  wild.masses[0] = std::numeric_limits<float>::infinity();
  problem.worlds = {wild};
  CHECK(Evaluator(problem).Evaluate(std::vector<Genome>{d.controllers[0].genes})[0].fitness <= kVoidScore);
}

TEST_CASE("worlds: drawn again they are the same, each differs, and none is further away than it may be") {
  const WorldNoise noise;
  const auto drawn = DrawWorlds(7, kMaxWorlds, 9);
  CHECK(drawn == DrawWorlds(7, kMaxWorlds, 9));
  CHECK(drawn != DrawWorlds(8, kMaxWorlds, 9));
  // Fewer worlds are the first of more.
  const auto few = DrawWorlds(7, 4, 9);
  REQUIRE(few.size() == 3);
  CHECK(std::ranges::equal(few, std::span(drawn).first(3)));
  std::set<float> frictions;
  std::set<int> delays;
  for (const TrialWorld& world : drawn) {
    frictions.insert(world.friction);
    delays.insert(world.delay_steps);
    CHECK(std::abs(static_cast<double>(world.friction) - 1.0) <= noise.friction + 1e-6);
    CHECK(std::abs(static_cast<double>(world.slope_rad)) <= noise.slope_rad + 1e-6);
    CHECK((world.delay_steps >= 0 && world.delay_steps <= noise.delay_steps));
    REQUIRE(world.masses.size() == 9);
    for (const float mass : world.masses)
      CHECK(std::abs(static_cast<double>(mass) - 1.0) <= noise.mass + 1e-6);
  }
  // The finest step changes nothing else.
  auto fine = DrawWorlds(7, kMaxWorlds, 9, {.halvings = 2});
  std::set<int> substeps;
  for (TrialWorld& world : fine) substeps.insert(std::exchange(world.substeps, 1));
  CHECK(substeps == std::set{1, 2, 4});
  CHECK(fine == drawn);
  CHECK(frictions.size() == drawn.size());
  CHECK(delays.size() > 1);
}

TEST_CASE("delay: joints do late what they would have done at once", "[determinism]") {
  // The timer decides without the plant, so waiting is the same as beginning later.
  const Document d = StarManTravel(SenseKind::kTimer);
  const Skeleton body(d.figure);
  const int delay = GENERATE(0, 1, 3, kMostDelaySteps);
  CAPTURE(delay);
  const Controller timed = RandomController(d.figure, d.senses, 5);
  const std::vector<Clip> at_once{{.controller = 0, .start_step = 0}},
      later{{.controller = 0, .start_step = delay}};
  const auto hash_of = [&](const std::vector<Clip>& clips, int late) {
    const auto takeovers = DecodeClips(clips, std::span(&timed, 1), FigurePlant<1>::PortsOf(body), kStep);
    Rollout<FigurePlant, 1> rollout(body, d.environment, d.start, {}, takeovers);
    rollout.Delay(late);
    TrajectoryHash hash;
    rollout.RunTo(400, kNothing, [&] { rollout.PlantNow().AddTo(hash, 0); });
    return hash.Value();
  };
  CHECK(hash_of(at_once, delay) == hash_of(later, 0));
  if (delay > 0) CHECK(hash_of(at_once, delay) != hash_of(at_once, 0));
}

TEST_CASE("delay: who takes over late lets the joints follow what was decided before", "[evaluator]") {
  // A pose that is held goes on to be held, so a delay changes nothing, however the lanes are filled.
  Document d = StarManTravel(SenseKind::kPhysical);
  d.model = GENERATE(1, 2);
  d.start = {.drop_height_m = 0.3f, .velocity_x_mps = 1.0f, .spin_radps = 1.5f};
  const std::vector<float> pose(static_cast<std::size_t>(d.figure.Joints()), 0.6f);
  const Controller held = HoldPose(d.figure, pose, 0.1f);
  d.senses = held.senses;
  d.rules = held.rules;
  Problem problem = ProblemOf(d);
  problem.beginnings = {{.controllers = {held}, .clips = {{.controller = 0, .start_step = 0}}, .steps = 40}};
  const std::vector<Genome> genomes(3, held.genes);
  const auto at_once = Evaluator(problem, true).Evaluate(genomes);
  problem.delay_steps = 3;
  const auto late = Evaluator(problem, true).Evaluate(genomes);
  for (std::size_t i = 0; i < genomes.size(); ++i) {
    CHECK(late[i].fitness == at_once[i].fitness);
    CHECK(late[i].trajectory_hash == at_once[i].trajectory_hash);
  }
}

TEST_CASE("substeps: prescribed joints turn as ever, at a finer step", "[determinism]") {
  const Document d = StarManTravel(SenseKind::kTimer);
  const Skeleton body(d.figure);
  const Controller timed = RandomController(d.figure, d.senses, 5);
  const std::vector<Clip> clips{{.controller = 0, .start_step = 0}};
  const auto takeovers = DecodeClips(clips, std::span(&timed, 1), FigurePlant<1>::PortsOf(body), kStep);
  Rollout<FigurePlant, 1> usual(body, d.environment, d.start, {}, takeovers);
  const int substeps = GENERATE(2, 8, kMostSubsteps);
  Rollout<FigurePlant, 1> fine(body, d.environment, d.start, {}, takeovers, kStep, substeps);
  CHECK(fine.PlantStep() == kStep / static_cast<float>(substeps));
  int parts = 0;
  for (int step = 1; step <= 400; ++step) {
    usual.RunTo(step, kNothing, kNothing);
    fine.RunTo(step, kNothing, kNothing, [&] { ++parts; });
    for (std::size_t j = 0; j < static_cast<std::size_t>(d.figure.Joints()); ++j) {
      CAPTURE(step, j);
      CHECK(std::abs(usual.Felt().position[j][0] - fine.Felt().position[j][0]) < 2e-4f);
    }
  }
  CHECK(parts == 400 * (substeps - 1));
}

TEST_CASE("substeps: a push is given once, and one who stands feels the whole weight", "[evaluator]") {
  Document d = StarManTravel(SenseKind::kPhysical);
  const Mechanism body(d.figure);
  const int substeps = GENERATE(1, 4, kMostSubsteps);
  CAPTURE(substeps);
  d.start.drop_height_m = 50.0f;
  const std::vector<Push> pushes{
      {.step = 10, .endpoint = kCentreOfMass, .impulse_x_ns = 5.0f, .impulse_y_ns = 0.0f}};
  Rollout<FigurePlant, 1> flying(body, d.environment, d.start, pushes, {}, kStep, substeps);
  flying.RunTo(50, kNothing, kNothing);
  CHECK(flying.PlantNow().Observe(0).velocity_x_mps == Catch::Approx(5.0f / body.mass_kg));
  CHECK((*flying.Felt().rise)[0] == Catch::Approx(-kStandardGravity * 0.5f).epsilon(1e-4));

  d.start.drop_height_m = 0.0f;
  Rollout<FigurePlant, 1> standing(body, d.environment, d.start, {}, {}, kStep, substeps);
  standing.RunTo(100, kNothing, kNothing);
  float impulse = 0.0f;
  for (std::size_t k = 0; k < static_cast<std::size_t>(d.figure.Rods()) + 1; ++k)
    impulse += standing.Felt().impulse[k][0];
  CHECK(impulse == Catch::Approx(body.mass_kg * kStandardGravity * kStep).epsilon(1e-3));
}

TEST_CASE("substeps: style terms count every one of them", "[evaluator]") {
  Document d = StarManTravel(SenseKind::kTimer);
  d.model = GENERATE(1, 2);
  Problem problem = ProblemOf(d);
  problem.traits = true;
  problem.task.duration_steps = 100;
  const std::vector<Genome> genomes{RandomController(d.figure, d.senses, 5).genes};
  const Terms usual = Evaluator(problem).Evaluate(genomes)[0].terms;
  problem.substeps = 8;
  const Terms fine = Evaluator(problem).Evaluate(genomes)[0].terms;
  CHECK(fine.effort_rad == Catch::Approx(usual.effort_rad).epsilon(0.05));
  CHECK(fine.head_height_m == Catch::Approx(usual.head_height_m).epsilon(0.2));
  CHECK(fine.travel_m != usual.travel_m);
}

}  // namespace gaitsmith::test
