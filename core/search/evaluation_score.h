// SPDX-License-Identifier: MIT
// What a search is told of an evaluated motion. Here searches and physics meet; the rest of core/search knows
// nothing of physics.
#pragma once

#include "core/rollout/evaluator.h"
#include "core/search/search.h"

namespace gaitsmith {

/// Fitness holds every weighted term; beside it stand the paper's three, which MAP-Elites sorts by.
[[nodiscard]] inline Score ScoreOf(const Evaluation& evaluation) {
  return {evaluation.fitness,
          {evaluation.terms.max_cm_height_m, evaluation.terms.slip_sum_m, evaluation.terms.rotations}};
}

}  // namespace gaitsmith
