// SPDX-License-Identifier: MIT
// Scores genomes: simulates each one's whole motion, several side by side in lanes, and measures it.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/rollout/evaluation.h"
#include "core/rollout/problem.h"

namespace gaitsmith {

class BatchEvaluator;

class Evaluator {
 public:
  /// Figures simulated side by side. No count changes a bit of any result.
  static constexpr int kLaneCounts[] = {1, 2, 4, 8, 16};
  static constexpr int kDefaultLanes = 4;  // one register of SSE or of WebAssembly

  /// @param problem   valid; copied. Its model picks the plant
  /// @param with_hash whether evaluations carry the trajectory's hash
  explicit Evaluator(const Problem& problem, bool with_hash = false);

  /// With another number of lanes, for those who check that it does not matter.
  /// @param lanes one of kLaneCounts
  Evaluator(const Problem& problem, int lanes, bool with_hash = false);

  /// With a plant that no document can name: a PlantEvaluator of it.
  explicit Evaluator(std::shared_ptr<const BatchEvaluator> batch) : batch_(std::move(batch)) {}

  /// @param genomes any number of them, each with Problem::Shape().Genes() genes
  /// @return an evaluation for each, in order
  [[nodiscard]] std::vector<Evaluation> Evaluate(std::span<const std::span<const Gene>> genomes) const;
  [[nodiscard]] std::vector<Evaluation> Evaluate(std::span<const Genome> genomes) const;

 private:
  std::shared_ptr<const BatchEvaluator> batch_;
};

}  // namespace gaitsmith
