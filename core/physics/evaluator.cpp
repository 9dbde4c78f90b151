// SPDX-License-Identifier: MIT
#include "core/physics/evaluator.h"

#include <algorithm>

#include "core/physics/simulation.h"

namespace gaitsmith {

std::vector<std::array<float, 2>> JointLimits(const Skeleton& skeleton) {
  std::vector<std::array<float, 2>> limits;
  for (int joint = 0; joint < skeleton.joints; ++joint) {
    const Skeleton::Limb& limb = skeleton.limbs[static_cast<std::size_t>(joint) + 1];
    limits.push_back({limb.min_rad, limb.max_rad});
  }
  return limits;
}

Evaluator::Evaluator(const Problem& problem, int lanes, bool with_hash)
    : problem_(problem),
      skeleton_(problem.figure),
      joint_limits_(JointLimits(skeleton_)),
      lanes_(lanes),
      with_hash_(with_hash) {}

template <int W>
void Evaluator::EvaluateLanes(std::span<const std::span<const Gene>> genomes,
                              std::span<Evaluation> results) const {
  const Bank<W> bank(problem_.Shape(), problem_.senses, genomes, joint_limits_, kStep);
  Simulation<W> simulation(skeleton_, problem_.environment, problem_.start, problem_.pushes);
  simulation.Follow(bank);
  std::array<TrajectoryHash, W> hashes;
  for (int step = 0; step < problem_.task.duration_steps; ++step) {
    simulation.Step();
    if (!with_hash_) continue;
    for (int lane = 0; lane < W; ++lane) simulation.AddTo(hashes[static_cast<std::size_t>(lane)], lane);
  }
  for (std::size_t i = 0; i < results.size(); ++i) {
    results[i].terms = simulation.TermsOf(static_cast<int>(i));
    results[i].fitness = Fitness(problem_.task, results[i].terms);
    if (with_hash_) results[i].trajectory_hash = hashes[i].Value();
  }
}

std::vector<Evaluation> Evaluator::Evaluate(std::span<const std::span<const Gene>> genomes) const {
  std::vector<Evaluation> results(genomes.size());
  const auto width = static_cast<std::size_t>(lanes_);
  for (std::size_t at = 0; at < genomes.size(); at += width) {
    const std::size_t count = std::min(width, genomes.size() - at);
    const auto batch = genomes.subspan(at, count);
    const std::span<Evaluation> out(results.data() + at, count);
    switch (lanes_) {
      case 1:
        EvaluateLanes<1>(batch, out);
        break;
      case 2:
        EvaluateLanes<2>(batch, out);
        break;
      case 4:
        EvaluateLanes<4>(batch, out);
        break;
      case 8:
        EvaluateLanes<8>(batch, out);
        break;
      default:
        EvaluateLanes<16>(batch, out);
        break;
    }
  }
  return results;
}

std::vector<Evaluation> Evaluator::Evaluate(std::span<const Genome> genomes) const {
  const std::vector<std::span<const Gene>> spans(genomes.begin(), genomes.end());
  return Evaluate(spans);
}

}  // namespace gaitsmith
