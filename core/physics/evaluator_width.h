// SPDX-License-Identifier: MIT
// How the evaluator simulates W figures side by side. Only for evaluator*.cpp.
#pragma once

#include <array>

#include "core/physics/evaluator.h"
#include "core/physics/simulation.h"

namespace gaitsmith {

template <int W>
void Evaluator::EvaluateWidth(const Evaluator& evaluator, std::span<const std::span<const Gene>> genomes,
                              std::span<Evaluation> results) {
  const Problem& problem = evaluator.problem_;
  const Controllers<W> controllers =
      DecodeControllers<W>(problem.Shape(), problem.senses, genomes, evaluator.joint_limits_, kStep);
  Simulation<W> simulation(evaluator.skeleton_, problem.environment, problem.start, problem.pushes);
  simulation.Follow(controllers);
  std::array<TrajectoryHash, W> hashes;
  for (int step = 0; step < problem.task.duration_steps; ++step) {
    simulation.Step();
    if (!evaluator.with_hash_) continue;
    for (int lane = 0; lane < W; ++lane) simulation.AddTo(hashes[static_cast<std::size_t>(lane)], lane);
  }
  for (std::size_t i = 0; i < results.size(); ++i) {
    results[i].terms = simulation.TermsOf(static_cast<int>(i));
    results[i].fitness = Fitness(problem.task, results[i].terms);
    if (evaluator.with_hash_) results[i].trajectory_hash = hashes[i].Value();
  }
}

}  // namespace gaitsmith
