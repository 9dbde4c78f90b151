// SPDX-License-Identifier: MIT
#include "core/search/search.h"

#include "core/search/cma_es.h"
#include "core/search/generational_ga.h"
#include "core/search/map_elites.h"
#include "core/search/nelder_mead.h"
#include "core/search/population_hill_climbing.h"
#include "core/search/powell.h"
#include "core/search/random_search.h"
#include "core/search/steady_state_ga.h"
#include "core/search/torus_ga.h"
#include "core/search/two_stage.h"

namespace gaitsmith {

void Search::Tell(std::span<const float> fitness) {
  std::vector<Score> scores;
  scores.reserve(fitness.size());
  for (const float value : fitness) scores.push_back({.fitness = value});
  Tell(scores);
}

std::unique_ptr<Search> MakeSearch(const SearchSettings& settings, const SearchSpace& space) {
  switch (settings.algorithm) {
    case Algorithm::kRandomSearch:
      return std::make_unique<RandomSearch>(settings, space);
    case Algorithm::kSphc:
      break;
    case Algorithm::kGga:
      return std::make_unique<GenerationalGa>(settings, space);
    case Algorithm::kSsga:
      return std::make_unique<SteadyStateGa>(settings, space);
    case Algorithm::kShc: {
      // Figure 4 is Figure 5 with a single individual and no reseeding.
      SearchSettings alone = settings;
      alone.population = 1;
      return std::make_unique<PopulationHillClimbing>(alone, space);
    }
    case Algorithm::kMpga:
      return std::make_unique<TorusGa>(settings, space);
    case Algorithm::kNelderMead:
      return std::make_unique<NelderMead>(settings, space);
    case Algorithm::kPowell:
      return std::make_unique<Powell>(settings, space);
    case Algorithm::kCmaEs:
      return std::make_unique<CmaEs>(settings, space);
    case Algorithm::kMapElites:
      return std::make_unique<MapElites>(settings, space);
    case Algorithm::kTwoStage:
      return std::make_unique<TwoStage>(settings, space);
  }
  return std::make_unique<PopulationHillClimbing>(settings, space);
}

}  // namespace gaitsmith
