// SPDX-License-Identifier: MIT
// A search of MAP-Elites to its end, and the map of styles that it leaves.
#pragma once

#include <catch_amalgamated.hpp>

#include "core/numeric/bit_stream.h"
#include "core/rollout/evaluator.h"
#include "core/search/evaluation_score.h"
#include "shell/results/elite_map.h"
#include "shell/search/search_progress.h"

namespace gaitsmith::test {

/// Searches a document with its own settings. @return the last report, with the state of the search
inline shell::SearchProgress SearchedToEnd(const Document& d) {
  const Evaluator evaluator(ProblemOf(d));
  const auto search = MakeSearch(d.search, SpaceOf(d));
  while (!search->Done()) {
    std::vector<Score> scores;
    for (const Evaluation& one : evaluator.Evaluate(search->Ask(40))) scores.push_back(ScoreOf(one));
    search->Tell(scores);
  }
  BitWriter state;
  search->Save(state);
  return {.state = shell::SearchState::kDone,
          .evaluations = search->Evaluations(),
          .budget = d.search.evaluations,
          .best_fitness = search->BestFitness(),
          .curve = search->Curve(),
          .best_genome = search->BestGenome(),
          .saved = state.Bytes()};
}

inline shell::EliteMap MapOf(const Document& searched) {
  auto map = shell::EliteMap::Of(searched, SearchedToEnd(searched).saved);
  REQUIRE(map);
  return std::move(*map);
}

}  // namespace gaitsmith::test
