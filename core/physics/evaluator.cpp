// SPDX-License-Identifier: MIT
#include "core/physics/evaluator.h"

#include <algorithm>

#include "core/physics/evaluator_width.h"

namespace gaitsmith {

std::vector<std::array<float, 2>> JointLimits(const Skeleton& skeleton) {
  std::vector<std::array<float, 2>> limits;
  for (int joint = 0; joint < skeleton.joints; ++joint) {
    const Skeleton::Limb& limb = skeleton.limbs[static_cast<std::size_t>(joint) + 1];
    limits.push_back({limb.min_rad, limb.max_rad});
  }
  return limits;
}

Evaluator::Evaluator(const Problem& problem, Width width, bool with_hash)
    : problem_(problem),
      skeleton_(problem.figure),
      joint_limits_(JointLimits(skeleton_)),
      width_(width),
      with_hash_(with_hash) {}

Evaluator::Evaluator(const Problem& problem, bool with_hash)
    : Evaluator(problem, {kDefaultLanes, &EvaluateWidth<kDefaultLanes>}, with_hash) {}

std::vector<Evaluation> Evaluator::Evaluate(std::span<const std::span<const Gene>> genomes) const {
  std::vector<Evaluation> results(genomes.size());
  for (std::size_t at = 0; at < genomes.size(); at += width_.lanes) {
    const std::size_t count = std::min(width_.lanes, genomes.size() - at);
    width_.evaluate(*this, genomes.subspan(at, count), std::span(results).subspan(at, count));
  }
  return results;
}

std::vector<Evaluation> Evaluator::Evaluate(std::span<const Genome> genomes) const {
  const std::vector<std::span<const Gene>> spans(genomes.begin(), genomes.end());
  return Evaluate(spans);
}

}  // namespace gaitsmith
