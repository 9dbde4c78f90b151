// SPDX-License-Identifier: MIT
// Converts an evaluation of a motion to a search's score. This is the only place where searches and physics
// meet. The rest of core/search does not depend on physics.
#pragma once

#include "core/rollout/evaluator.h"
#include "core/search/search.h"

namespace gaitsmith {

/// The fitness includes every weighted term. The style contains the paper's three terms, which MAP-Elites
/// uses.
[[nodiscard]] inline Score ScoreOf(const Evaluation& evaluation) {
  return {evaluation.fitness,
          {evaluation.terms.max_cm_height_m, evaluation.terms.slip_sum_m, evaluation.terms.rotations}};
}

}  // namespace gaitsmith
