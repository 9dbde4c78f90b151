// SPDX-License-Identifier: MIT
// Figures of springs behind the one simulation loop: controllers drive them, tasks score them.
#include <catch_amalgamated.hpp>
#include <memory>

#include "core/numeric/random.h"
#include "core/rollout/batch_evaluator.h"
#include "core/rollout/evaluator.h"
#include "core/search/operators.h"
#include "tests/spring_scene.h"

using namespace gaitsmith;

namespace {

Problem Travelling(SenseKind senses, ControllerKind kind) {
  Problem problem;
  problem.figure = Table();
  problem.task.duration_steps = 500;
  problem.senses.kind = senses;
  problem.senses.period_steps = 60;
  problem.senses.tau_min_s = 0.05f;
  problem.senses.tau_max_s = 0.3f;
  problem.kind = kind;
  problem.rules = 6;
  for (const StyleTerm term :
       {StyleTerm::kEffort, StyleTerm::kUpright, StyleTerm::kWork, StyleTerm::kHeadHeight})
    problem.task.weights[static_cast<std::size_t>(term)] = 0.001f;
  return problem;
}

std::vector<Genome> RandomGenomes(const Problem& problem, int count) {
  const ControllerShape shape = problem.ShapeFor(SpringPlant<1>::CountPorts(problem.figure));
  std::vector<Genome> genomes;
  for (int i = 0; i < count; ++i) {
    RandomStream random(11, static_cast<std::uint64_t>(i), 0);
    genomes.push_back(RandomGenome(shape, problem.senses, Variation{}, random));
  }
  return genomes;
}

template <int W>
std::vector<Evaluation> Evaluated(const Problem& problem, const std::vector<Genome>& genomes) {
  return Evaluator(std::make_shared<PlantEvaluator<SpringPlant, W>>(problem, true)).Evaluate(genomes);
}

}  // namespace

TEST_CASE("springs: every number of lanes gives an evaluation the same bits",
          "[core][springs][determinism]") {
  const auto [senses, kind] =
      GENERATE(table<SenseKind, ControllerKind>({{SenseKind::kPhysical, ControllerKind::kRules},
                                                 {SenseKind::kTimer, ControllerKind::kRules},
                                                 {SenseKind::kTimer, ControllerKind::kTrajectory}}));
  Problem problem = Travelling(senses, kind);
  problem.substeps = GENERATE(1, 2);
  const std::vector<Genome> genomes = RandomGenomes(problem, 21);
  const std::vector<Evaluation> alone = Evaluated<1>(problem, genomes),
                                together = Evaluated<8>(problem, genomes);
  for (std::size_t i = 0; i < genomes.size(); ++i) {
    CHECK(alone[i].trajectory_hash == together[i].trajectory_hash);
    CHECK(alone[i].fitness == together[i].fitness);
    CHECK(alone[i].terms.work_j == together[i].terms.work_j);
  }
}

TEST_CASE("springs: among random rules some make a table of springs travel", "[core][springs]") {
  const SenseKind senses = GENERATE(SenseKind::kPhysical, SenseKind::kTimer);
  const Problem problem = Travelling(senses, ControllerKind::kRules);
  float farthest = 0.0f;
  int broken = 0;
  for (const Evaluation& one : Evaluated<8>(problem, RandomGenomes(problem, 400))) {
    broken += one.terms.broke_physics ? 1 : 0;
    if (one.terms.broke_physics) continue;
    farthest = std::max(farthest, std::abs(one.terms.travel_m));
    CHECK(one.terms.work_j >= 0.0f);
    CHECK(std::abs(one.terms.upright) <= 1.0001f);
  }
  CHECK(farthest > 1.0f);
  CHECK(broken == 0);
}
