// SPDX-License-Identifier: MIT
#include "core/rollout/transition_map.h"

#include <utility>

#include "core/rollout/models.h"
#include "core/rollout/moment_scorer.h"

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

TransitionMap::TransitionMap(std::shared_ptr<const MomentScorer> scorer, int moments)
    : scorer_(std::move(scorer)), order_(CoarseFirst(moments)), usual_(scorer_->UsualScore()) {}

TransitionMap::TransitionMap(const Problem& problem, const Genome& genome, std::span<const int> steps)
    : TransitionMap(WithPlantOf(problem.model,
                                [&]<template <int> class PlantOf>() -> std::shared_ptr<const MomentScorer> {
                                  return std::make_shared<PlantMomentScorer<PlantOf>>(problem, genome, steps);
                                }),
                    static_cast<int>(steps.size())) {}

std::vector<float> TransitionMap::Scores(int first, int count) const {
  std::vector<float> scores;
  scores.reserve(static_cast<std::size_t>(count));
  for (int place = first; place < first + count; ++place) {
    scores.push_back(scorer_->ScoreFrom(order_[static_cast<std::size_t>(place)]));
  }
  return scores;
}

}  // namespace gaitsmith
