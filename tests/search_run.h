// SPDX-License-Identifier: MIT
// Runs a search, on physics or on a test function, and keeps its results.
#pragma once

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <vector>

#include "core/document/document.h"
#include "core/rollout/evaluator.h"
#include "core/rollout/models.h"
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

/// What a bank sensed during a motion of its own, evenly spaced, as the recorded motion has it. Empty for a
/// network.
/// @param problem without beginnings
inline std::vector<Sighting> SightingsOf(const Problem& problem, const Genome& genes, int count) {
  if (problem.kind != ControllerKind::kRules) return {};
  REQUIRE(problem.beginnings.empty());
  const Problem own = problem.bodies ? problem.WithBodyOf(genes) : problem;
  const auto controller_genes =
      static_cast<std::ptrdiff_t>(genes.size() - (problem.bodies ? problem.Shape().BodyGenes() : 0));
  const std::vector<Controller> controllers = {
      {"", own.kind, own.senses, own.rules, Genome(genes.begin(), genes.begin() + controller_genes)}};
  const std::vector<Clip> clips = {{.controller = 0, .start_step = 0}};
  const int duration = own.task.duration_steps;
  const Motion motion(Script{.figure = own.figure,
                             .environment = own.environment,
                             .start = own.start,
                             .pushes = own.pushes,
                             .controllers = controllers,
                             .clips = clips,
                             .steps = duration,
                             .model = own.model});
  const int senses = SenseCount(own.senses.kind, CountPorts(own.model, own.figure));
  const Edges edges = EdgesOf(own.senses.kind);
  std::vector<Sighting> sightings;
  for (int i = 1; i <= count; ++i) {
    const int frame = duration * i / count;
    Sighting& sighting = sightings.emplace_back();
    sighting.senses.reserve(static_cast<std::size_t>(senses));
    sighting.rule = motion.At(frame).rule;
    for (int sense = 0; sense < senses; ++sense)
      sighting.senses.push_back(Encode(motion.Sense(frame, sense), edges.low, edges.high));
  }
  return sightings;
}

inline bool Same(const Outcome& a, const Outcome& b) {
  return a.best == b.best && a.fitness == b.fitness &&
         std::ranges::equal(a.curve, b.curve, [](const auto& p, const auto& q) {
           return p.evaluation == q.evaluation && p.best == q.best;
         });
}

}  // namespace gaitsmith::test
