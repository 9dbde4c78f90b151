// SPDX-License-Identifier: MIT
// Scores genomes: simulates each one's whole motion, several side by side in lanes, and measures it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/physics/motion_state.h"
#include "core/physics/skeleton.h"
#include "core/rollout/problem.h"

namespace gaitsmith {

/// What one motion was worth.
struct Evaluation {
  float fitness = kVoidScore;         // with several beginnings: the mean, void if one is
  Terms terms;                        // likewise; further ones only where the task weighs them
  std::uint64_t trajectory_hash = 0;  // only filled when asked for
};

/// Takes one more of several evaluations into their mean. @param before how many are in it
void AddToMean(Evaluation& mean, const Evaluation& next, int before);

class Evaluator {
 public:
  /// Figures simulated side by side. No count changes a bit of any result.
  static constexpr int kLaneCounts[] = {1, 2, 4, 8, 16};
  static constexpr int kDefaultLanes = 4;  // one register of SSE or of WebAssembly

  /// @param problem   valid; copied
  /// @param with_hash whether evaluations carry the trajectory's hash
  explicit Evaluator(const Problem& problem, bool with_hash = false);

  /// With another number of lanes, for those who check that it does not matter.
  /// @param lanes one of kLaneCounts
  Evaluator(const Problem& problem, int lanes, bool with_hash = false);

  /// @param genomes any number of them, each with Problem::Shape().Genes() genes
  /// @return an evaluation for each, in order
  [[nodiscard]] std::vector<Evaluation> Evaluate(std::span<const std::span<const Gene>> genomes) const;
  [[nodiscard]] std::vector<Evaluation> Evaluate(std::span<const Genome> genomes) const;

 private:
  /// How many figures share an instruction, and how those are scored.
  struct Width {
    std::size_t lanes;
    void (*evaluate)(const Evaluator&, std::span<const std::span<const Gene>>, std::span<Evaluation>);
  };
  Evaluator(const Problem& problem, Width width, bool with_hash);
  template <int W>
  static void EvaluateWidth(const Evaluator&, std::span<const std::span<const Gene>> genomes,
                            std::span<Evaluation> results);

  Problem problem_;
  Skeleton skeleton_;
  std::vector<std::array<float, 2>> joint_limits_;
  std::vector<Moment<1>> moments_;  // of the problem's beginnings
  Width width_;
  bool with_hash_;
};

/// Least and greatest angle of each joint [rad], in the skeleton's order.
[[nodiscard]] std::vector<std::array<float, 2>> JointLimits(const Skeleton&);

}  // namespace gaitsmith
