// SPDX-License-Identifier: MIT
// Evaluators of every width. They are in a separate file so that a program that does not use them does not
// link them.
#include "core/rollout/batch_evaluator.h"
#include "core/rollout/evaluator.h"
#include "core/rollout/models.h"

namespace gaitsmith {

namespace {

template <template <int> class PlantOf>
std::shared_ptr<const BatchEvaluator> OfWidth(const Problem& problem, int lanes, bool with_hash) {
  switch (lanes) {
    case 1:
      return BatchEvaluatorOf<PlantOf, 1>(problem, with_hash);
    case 2:
      return BatchEvaluatorOf<PlantOf, 2>(problem, with_hash);
    case 4:
      return BatchEvaluatorOf<PlantOf, 4>(problem, with_hash);
    case 8:
      return BatchEvaluatorOf<PlantOf, 8>(problem, with_hash);
    default:
      return BatchEvaluatorOf<PlantOf, 16>(problem, with_hash);
  }
}

}  // namespace

Evaluator::Evaluator(const Problem& problem, int lanes, bool with_hash)
    : Evaluator(WithPlantOf(problem.model, [&]<template <int> class PlantOf>() {
        return OfWidth<PlantOf>(problem, lanes, with_hash);
      })) {}

}  // namespace gaitsmith
