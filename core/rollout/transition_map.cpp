// SPDX-License-Identifier: MIT
#include "core/rollout/transition_map.h"

#include <optional>

#include "core/physics/simulation.h"
#include "core/rollout/beginning.h"
#include "core/rollout/evaluator.h"
#include "core/rollout/style_meter.h"

namespace gaitsmith {

std::vector<int> CoarseFirst(int count) {
  constexpr int kCoarse = 16;
  std::vector<int> order;
  order.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; i += kCoarse) order.push_back(i);
  for (int spacing = kCoarse; spacing > 1; spacing /= 2) {
    for (int i = spacing / 2; i < count; i += spacing) order.push_back(i);
  }
  return order;
}

namespace {

Controllers<1> Decoded(const Problem& problem, const Skeleton& skeleton, const Genome& genome) {
  const std::span<const Gene> genes(genome);
  return DecodeControllers<1>(problem.Shape(), problem.senses, std::span(&genes, 1), JointLimits(skeleton),
                              kStep);
}

}  // namespace

TransitionMap::TransitionMap(const Problem& problem, const Genome& genome, std::span<const int> steps)
    : problem_(problem),
      skeleton_(problem.figure),
      controller_(Decoded(problem, skeleton_, genome)),
      moments_(MomentsDuring(problem.beginnings.front(), problem, skeleton_, steps)),
      order_(CoarseFirst(static_cast<int>(steps.size()))),
      usual_(ScoreFrom(nullptr)) {}

std::vector<float> TransitionMap::Scores(int first, int count) const {
  std::vector<float> scores;
  scores.reserve(static_cast<std::size_t>(count));
  for (int place = first; place < first + count; ++place) {
    const int index = order_[static_cast<std::size_t>(place)];
    scores.push_back(ScoreFrom(&moments_[static_cast<std::size_t>(index)]));
  }
  return scores;
}

float TransitionMap::ScoreFrom(const Moment<1>* moment) const {
  std::span<const Push> pushes = problem_.pushes;
  if (moment == nullptr) pushes = {};
  Simulation<1> simulation(skeleton_, problem_.environment, problem_.start, pushes);
  if (moment != nullptr) simulation.BeginAt(*moment);
  simulation.Follow(controller_);
  const FurtherTerms weighted = WeightedFurtherTerms(problem_.task);
  std::optional<StyleMeter<1>> meter;
  if (weighted != FurtherTerms{}) meter.emplace(skeleton_, simulation.State(), weighted, kStep);
  for (int step = 0; step < problem_.task.duration_steps; ++step) {
    simulation.Step();
    if (meter) meter->Add();
  }
  Terms terms = simulation.TermsOf(0);
  if (meter) meter->Put(0, terms);
  return Fitness(problem_.task, terms);
}

}  // namespace gaitsmith
