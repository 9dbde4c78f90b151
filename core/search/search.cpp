// SPDX-License-Identifier: MIT
#include "core/search/search.h"

namespace gaitsmith {

void Search::Tell(std::span<const float> fitness) {
  std::vector<Score> scores;
  scores.reserve(fitness.size());
  for (const float value : fitness) scores.push_back({.fitness = value});
  Tell(scores);
}

std::unique_ptr<Search> MakeSearch(const SearchSettings& settings, const SearchSpace& space) {
  return kAlgorithms[static_cast<std::size_t>(settings.algorithm)].make(settings, space);
}

}  // namespace gaitsmith
