// SPDX-License-Identifier: MIT
#include "core/rollout/sightings.h"

#include "core/rollout/evaluator.h"

namespace gaitsmith {

std::vector<Sighting> SightingsOf(const Problem& problem, const Genome& genes, int count) {
  std::vector<Sighting> sightings;
  static_cast<void>(Evaluator(problem).Evaluate(std::span(&genes, 1), {count, std::span(&sightings, 1)}));
  return sightings;
}

}  // namespace gaitsmith
