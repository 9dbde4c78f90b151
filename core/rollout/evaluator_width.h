// SPDX-License-Identifier: MIT
// How the evaluator simulates W figures side by side. Only for evaluator*.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "core/physics/simulation.h"
#include "core/rollout/evaluator.h"
#include "core/rollout/style_meter.h"

namespace gaitsmith {

template <int W>
void Evaluator::EvaluateWidth(const Evaluator& evaluator, std::span<const std::span<const Gene>> genomes,
                              std::span<Evaluation> results) {
  const Problem& problem = evaluator.problem_;
  const Controllers<W> controllers =
      DecodeControllers<W>(problem.Shape(), problem.senses, genomes, evaluator.joint_limits_, kStep);
  const FurtherTerms weighted = WeightedFurtherTerms(problem.task);
  std::array<TrajectoryHash, W> hashes;
  const std::size_t beginnings = evaluator.moments_.size();
  for (std::size_t begin = 0; begin < std::max<std::size_t>(1, beginnings); ++begin) {
    Simulation<W> simulation(evaluator.skeleton_, problem.environment, problem.start, problem.pushes);
    if (beginnings > 0) simulation.BeginAt(evaluator.moments_[begin]);
    simulation.Follow(controllers);
    // Most searches weigh none of the further terms, and then nobody measures them.
    std::optional<StyleMeter<W>> meter;
    if (weighted != FurtherTerms{}) meter.emplace(evaluator.skeleton_, simulation.State(), weighted, kStep);
    for (int step = 0; step < problem.task.duration_steps; ++step) {
      simulation.Step();
      if (meter) meter->Add();
      if (!evaluator.with_hash_) continue;
      for (int lane = 0; lane < W; ++lane) simulation.AddTo(hashes[static_cast<std::size_t>(lane)], lane);
    }
    for (std::size_t i = 0; i < results.size(); ++i) {
      Evaluation result;
      result.terms = simulation.TermsOf(static_cast<int>(i));
      if (meter) meter->Put(static_cast<int>(i), result.terms);
      result.fitness = Fitness(problem.task, result.terms);
      if (beginnings > 1) {
        AddToMean(results[i], result, static_cast<int>(begin));
      } else {
        results[i] = result;
      }
    }
  }
  if (!evaluator.with_hash_) return;
  for (std::size_t i = 0; i < results.size(); ++i) results[i].trajectory_hash = hashes[i].Value();
}

}  // namespace gaitsmith
