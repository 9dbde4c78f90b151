// SPDX-License-Identifier: MIT
#include "core/rollout/evaluator.h"

#include <algorithm>

#include "core/rollout/batch_evaluator.h"
#include "core/rollout/models.h"

namespace gaitsmith {

Evaluator::Evaluator(const Problem& problem, bool with_hash)
    : Evaluator(WithPlantOf(problem.model,
                            [&]<template <int> class PlantOf>() -> std::shared_ptr<const BatchEvaluator> {
                              return BatchEvaluatorOf<PlantOf, kDefaultLanes>(problem, with_hash);
                            })) {}

std::vector<Evaluation> Evaluator::EvaluateAll(std::span<const std::span<const Gene>> genomes,
                                               const Watch& watch) const {
  std::vector<Evaluation> results(genomes.size());
  const std::size_t lanes = batch_->Lanes();
  for (std::size_t at = 0; at < genomes.size(); at += lanes) {
    const std::size_t count = std::min(lanes, genomes.size() - at);
    Watch here = watch;
    if (watch.count > 0) here.of_genomes = watch.of_genomes.subspan(at, count);
    batch_->Evaluate(genomes.subspan(at, count), std::span(results).subspan(at, count), here);
  }
  return results;
}

std::vector<Evaluation> Evaluator::Evaluate(std::span<const std::span<const Gene>> genomes) const {
  return EvaluateAll(genomes, {});
}

std::vector<Evaluation> Evaluator::Evaluate(std::span<const Genome> genomes) const {
  return Evaluate(genomes, Watch{});
}

std::vector<Evaluation> Evaluator::Evaluate(std::span<const Genome> genomes, const Watch& watch) const {
  const std::vector<std::span<const Gene>> spans(genomes.begin(), genomes.end());
  return EvaluateAll(spans, watch);
}

}  // namespace gaitsmith
