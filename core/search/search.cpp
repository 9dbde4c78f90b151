// SPDX-License-Identifier: MIT
#include "core/search/search.h"

#include "core/search/population_hill_climbing.h"
#include "core/search/random_search.h"

namespace gaitsmith {

std::unique_ptr<Search> MakeSearch(const SearchSettings& settings, const SearchSpace& space) {
  switch (settings.algorithm) {
    case Algorithm::kRandomSearch:
      return std::make_unique<RandomSearch>(settings, space);
    case Algorithm::kSphc:
      break;
  }
  return std::make_unique<PopulationHillClimbing>(settings, space);
}

}  // namespace gaitsmith
