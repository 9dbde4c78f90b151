// SPDX-License-Identifier: MIT
// Scores genomes: simulates each one's whole motion, several side by side in lanes, and measures it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/physics/problem.h"
#include "core/physics/skeleton.h"

namespace gaitsmith {

/// What one motion was worth.
struct Evaluation {
  float fitness = kVoidScore;
  Terms terms;
  std::uint64_t trajectory_hash = 0;  // only filled when asked for: it costs a tenth of the simulation
};

class Evaluator {
 public:
  /// Lanes simulated side by side. No count changes a bit of any result.
  static constexpr int kLaneCounts[] = {1, 2, 4, 8, 16};
#if defined(__clang__)
  static constexpr int kDefaultLanes =
      16;  // clang keeps wide lanes in several registers, also for WebAssembly
#else
  static constexpr int kDefaultLanes = 4;  // gcc spills anything wider than one register to memory
#endif

  /// @param problem valid; copied
  /// @param lanes   one of kLaneCounts
  explicit Evaluator(const Problem& problem, int lanes = kDefaultLanes, bool with_hash = false);

  /// @param genomes any number of them, each with Problem::Shape().Genes() genes
  /// @return an evaluation for each, in order
  [[nodiscard]] std::vector<Evaluation> Evaluate(std::span<const std::span<const Gene>> genomes) const;
  [[nodiscard]] std::vector<Evaluation> Evaluate(std::span<const Genome> genomes) const;

 private:
  template <int W>
  void EvaluateLanes(std::span<const std::span<const Gene>> genomes, std::span<Evaluation> results) const;

  Problem problem_;
  Skeleton skeleton_;
  std::vector<std::array<float, 2>> joint_limits_;
  int lanes_;
  bool with_hash_;
};

/// Least and greatest angle of each joint [rad], in the skeleton's order.
[[nodiscard]] std::vector<std::array<float, 2>> JointLimits(const Skeleton&);

}  // namespace gaitsmith
