// SPDX-License-Identifier: MIT
// Scores genomes: simulates the whole motion of each, several side by side in lanes, and measures it.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/rollout/evaluation.h"
#include "core/rollout/problem.h"
#include "core/rollout/sighting_recorder.h"

namespace gaitsmith {

class BatchEvaluator;

class Evaluator {
 public:
  /// Numbers of figures that can be simulated side by side. The choice does not change a bit of any result.
  static constexpr int kLaneCounts[] = {1, 2, 4, 8, 16};
  static constexpr int kDefaultLanes = 4;  // one register of SSE or of WebAssembly

  /// @param problem   must be valid; copied. Its model chooses the plant
  /// @param with_hash whether evaluations contain the trajectory's hash
  explicit Evaluator(const Problem& problem, bool with_hash = false);

  /// With another number of lanes, for tests that the number does not matter.
  /// @param lanes one of kLaneCounts
  Evaluator(const Problem& problem, int lanes, bool with_hash = false);

  /// With a PlantEvaluator, for a plant that is not a model of documents.
  explicit Evaluator(std::shared_ptr<const BatchEvaluator> batch) : batch_(std::move(batch)) {}

  /// @param genomes any number of them, each with Problem::Shape().Genes() genes
  /// @return an evaluation for each, in order
  [[nodiscard]] std::vector<Evaluation> Evaluate(std::span<const std::span<const Gene>> genomes) const;
  [[nodiscard]] std::vector<Evaluation> Evaluate(std::span<const Genome> genomes) const;
  /// The same, with sightings of each motion.
  [[nodiscard]] std::vector<Evaluation> Evaluate(std::span<const Genome> genomes, const Watch& watch) const;

 private:
  [[nodiscard]] std::vector<Evaluation> EvaluateAll(std::span<const std::span<const Gene>> genomes,
                                                    const Watch& watch) const;

  std::shared_ptr<const BatchEvaluator> batch_;
};

}  // namespace gaitsmith
