// SPDX-License-Identifier: MIT
// Converts an evaluation of a motion to a search's score, and a problem to the space of its controllers. This
// is the only place where searches and physics meet. The rest of core/search does not depend on physics.
#pragma once

#include "core/rollout/evaluator.h"
#include "core/rollout/sightings.h"
#include "core/search/search.h"

namespace gaitsmith {

/// The fitness includes every weighted term. The style contains the paper's three terms, which MAP-Elites
/// uses.
[[nodiscard]] inline Score ScoreOf(const Evaluation& evaluation) {
  return {evaluation.fitness,
          {evaluation.terms.max_cm_height_m, evaluation.terms.slip_sum_m, evaluation.terms.rotations},
          evaluation.traits};
}

/// The controllers that a search of the problem tries. @param start its first genome; empty: random
[[nodiscard]] inline SearchSpace SpaceOf(Problem problem, Genome start = {}) {
  SearchSpace space{problem.Shape(), problem.senses, std::move(start)};
  space.sightings = [problem = std::move(problem)](const Genome& genes, int count) {
    return SightingsOf(problem, genes, count);
  };
  return space;
}

}  // namespace gaitsmith
