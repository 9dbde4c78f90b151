// SPDX-License-Identifier: MIT
// Runs a search on a function in place of physics, and keeps what came of it.
#pragma once

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <vector>

#include "core/search/search.h"

namespace gaitsmith::test {

struct Outcome {
  Genome best;
  float fitness = 0.0f;
  std::vector<Search::CurvePoint> curve;
  int told = 0;
};

template <class Function>
Outcome Run(Search& search, int wanted, Function function) {
  Outcome outcome;
  while (!search.Done()) {
    const auto genomes = search.Ask(wanted);
    REQUIRE(!genomes.empty());
    std::vector<float> fitness;
    fitness.reserve(genomes.size());
    for (const Genome& genome : genomes) fitness.push_back(function(genome));
    search.Tell(fitness);
    outcome.told += static_cast<int>(genomes.size());
  }
  outcome.best = search.BestGenome();
  outcome.fitness = search.BestFitness();
  outcome.curve = search.Curve();
  return outcome;
}

inline bool Same(const Outcome& a, const Outcome& b) {
  return a.best == b.best && a.fitness == b.fitness &&
         std::ranges::equal(a.curve, b.curve, [](const auto& p, const auto& q) {
           return p.evaluation == q.evaluation && p.best == q.best;
         });
}

}  // namespace gaitsmith::test
