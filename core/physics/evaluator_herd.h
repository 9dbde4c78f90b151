// SPDX-License-Identifier: MIT
// How the evaluator simulates a herd W figures at a time. Only for evaluator*.cpp.
#pragma once

#include <algorithm>

#include "core/physics/evaluator.h"
#include "core/physics/simulation.h"

namespace gaitsmith {

template <int W>
void Evaluator::EvaluateHerd(const Evaluator& evaluator, std::span<const std::span<const Gene>> genomes,
                             std::span<Evaluation> results) {
  const Problem& problem = evaluator.problem_;
  std::vector<Bank<W>> banks;
  banks.reserve((genomes.size() + W - 1) / W);
  for (std::size_t at = 0; at < genomes.size(); at += W) {
    const std::size_t count = std::min(static_cast<std::size_t>(W), genomes.size() - at);
    banks.emplace_back(problem.Shape(), problem.senses, genomes.subspan(at, count), evaluator.joint_limits_,
                       kStep);
  }
  Simulation<W> simulation(evaluator.skeleton_, problem.environment, problem.start, problem.pushes,
                           static_cast<int>(genomes.size()));
  simulation.Follow(banks);
  std::vector<TrajectoryHash> hashes(evaluator.with_hash_ ? genomes.size() : 0);
  for (int step = 0; step < problem.task.duration_steps; ++step) {
    simulation.Step();
    for (std::size_t i = 0; i < hashes.size(); ++i) simulation.AddTo(hashes[i], static_cast<int>(i));
  }
  for (std::size_t i = 0; i < results.size(); ++i) {
    results[i].terms = simulation.TermsOf(static_cast<int>(i));
    results[i].fitness = Fitness(problem.task, results[i].terms);
    if (!hashes.empty()) results[i].trajectory_hash = hashes[i].Value();
  }
}

}  // namespace gaitsmith
