// SPDX-License-Identifier: MIT
#include "core/rollout/evaluator.h"

#include <algorithm>

#include "core/rollout/beginning.h"
#include "core/rollout/evaluator_width.h"

namespace gaitsmith {

void AddToMean(Evaluation& mean, const Evaluation& next, int before) {
  const float share = 1.0f / static_cast<float>(before + 1);
  const auto add = [&](float& value, float more) {
    value = before == 0 ? more : value + (more - value) * share;
  };
  const bool broken = (before > 0 && mean.terms.broke_physics) || next.terms.broke_physics;
  add(mean.terms.travel_m, next.terms.travel_m);
  add(mean.terms.start_height_m, next.terms.start_height_m);
  add(mean.terms.max_cm_height_m, next.terms.max_cm_height_m);
  add(mean.terms.slip_sum_m, next.terms.slip_sum_m);
  add(mean.terms.rotations, next.terms.rotations);
  add(mean.terms.effort_rad, next.terms.effort_rad);
  add(mean.terms.upright, next.terms.upright);
  add(mean.terms.smoothness_radps2, next.terms.smoothness_radps2);
  add(mean.terms.head_height_m, next.terms.head_height_m);
  mean.terms.broke_physics = broken;
  const bool is_void = (before > 0 && mean.fitness <= kVoidScore) || next.fitness <= kVoidScore;
  add(mean.fitness, next.fitness);
  if (is_void) mean.fitness = kVoidScore;
}

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
      with_hash_(with_hash) {
  for (const Beginning& beginning : problem_.beginnings)
    moments_.push_back(MomentsDuring(beginning, problem_, skeleton_, std::span(&beginning.steps, 1)).front());
}

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
