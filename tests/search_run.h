// SPDX-License-Identifier: MIT
// Runs a search, on physics or on a test function, and keeps its results.
#pragma once

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <vector>

#include "core/document/document.h"
#include "core/rollout/evaluator.h"
#include "core/search/search.h"

namespace gaitsmith::test {

struct Outcome {
  Genome best;
  float fitness = 0.0f;
  std::vector<Search::CurvePoint> curve;
  int scored = 0;  // number of genomes
};

/// @param score returns the fitness of each genome of a list
template <class Scorer>
Outcome RunInBatches(Search& search, int wanted, Scorer score) {
  Outcome outcome;
  while (!search.Done()) {
    const auto genomes = search.Ask(wanted);
    REQUIRE(!genomes.empty());
    search.Tell(score(genomes));
    outcome.scored += static_cast<int>(genomes.size());
  }
  outcome.best = search.BestGenome();
  outcome.fitness = search.BestFitness();
  outcome.curve = search.Curve();
  return outcome;
}

template <class Function>
Outcome Run(Search& search, int wanted, Function function) {
  return RunInBatches(search, wanted, [&](const std::vector<Genome>& genomes) {
    std::vector<float> fitness;
    fitness.reserve(genomes.size());
    for (const Genome& genome : genomes) fitness.push_back(function(genome));
    return fitness;
  });
}

/// Runs the search of a document with physics. @param document must be valid
inline Outcome RunSearchOf(const Document& document) {
  const auto search = MakeSearch(document.search, SpaceOf(document));
  const Evaluator evaluator(ProblemOf(document));
  return RunInBatches(*search, 40, [&](const std::vector<Genome>& genomes) {
    std::vector<float> fitness;
    for (const Evaluation& one : evaluator.Evaluate(genomes)) fitness.push_back(one.fitness);
    return fitness;
  });
}

/// What a bank sensed during a motion of its own, evenly spaced. Empty for a network.
inline std::vector<Sighting> SightingsOf(const Problem& problem, const Genome& genes, int count) {
  std::vector<Sighting> sightings;
  static_cast<void>(Evaluator(problem).Evaluate(std::span(&genes, 1), {count, std::span(&sightings, 1)}));
  return sightings;
}

inline bool Same(const Outcome& a, const Outcome& b) {
  return a.best == b.best && a.fitness == b.fitness &&
         std::ranges::equal(a.curve, b.curve, [](const auto& p, const auto& q) {
           return p.evaluation == q.evaluation && p.best == q.best;
         });
}

}  // namespace gaitsmith::test
