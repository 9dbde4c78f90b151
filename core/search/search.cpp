// SPDX-License-Identifier: MIT
#include "core/search/search.h"

#include <algorithm>

namespace gaitsmith {

void Search::Tell(std::span<const float> fitness) {
  std::vector<Score> scores;
  scores.reserve(fitness.size());
  for (const float value : fitness) scores.push_back({.fitness = value});
  Tell(scores);
}

namespace {

constexpr auto kMakers = [] {
  auto makers = AlgorithmColumn(&AlgorithmRow::make);
#ifdef GAITSMITH_FEW_SEARCHES
  // Of the small engine, whose pages search with these alone (web/explorable/scenes.js).
  using enum Algorithm;
  constexpr std::array kFew = {kRandomSearch, kSphc, kShc, kPoseCycle};
  for (const AlgorithmRow& row : kAlgorithms) {
    if (std::ranges::find(kFew, row.algorithm) == kFew.end()) {
      makers[static_cast<std::size_t>(row.algorithm)] = nullptr;
    }
  }
#endif
  return makers;
}();

}  // namespace

std::unique_ptr<Search> MakeSearch(const SearchSettings& settings, const SearchSpace& space) {
  SearchMaker* const make = kMakers[static_cast<std::size_t>(settings.algorithm)];
  return make ? make(settings, space) : nullptr;
}

}  // namespace gaitsmith
