// SPDX-License-Identifier: MIT
// Converts an evaluation of a motion to a search's score, and a problem to the space of its controllers. This
// is the only place where searches and physics meet. The rest of core/search does not depend on physics.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/rollout/evaluator.h"
#include "core/search/search.h"

namespace gaitsmith {

/// The fitness includes every weighted term. The style contains the paper's three terms, which MAP-Elites
/// uses.
[[nodiscard]] inline Score ScoreOf(const Evaluation& evaluation) {
  return {evaluation.fitness,
          {evaluation.terms.max_cm_height_m, evaluation.terms.slip_sum_m, evaluation.terms.rotations},
          evaluation.traits};
}

/// Scores the genomes of a search. A search that looks at the motion of one of the last few gets what was
/// recorded when they were scored: simulating it again would take longer than scoring four.
class Scorer {
 public:
  explicit Scorer(const Problem& problem)
      : shape_(problem.Shape()), senses_(problem.senses), memory_(std::make_shared<Memory>(problem)) {}

  /// The controllers that a search of the problem tries. @param start its first genome; empty: random
  [[nodiscard]] SearchSpace Space(Genome start = {}) const {
    SearchSpace space{shape_, senses_, std::move(start)};
    if (shape_.Kind() != ControllerKind::kRules) return space;  // only rules are sighted
    space.sightings = [memory = memory_](const Genome& genes, int count) {
      memory->count = count;
      const auto known = std::ranges::find(memory->genomes, genes);
      if (known != memory->genomes.end()) {
        const auto& sightings = memory->sightings[static_cast<std::size_t>(known - memory->genomes.begin())];
        if (sightings.size() == static_cast<std::size_t>(count)) return sightings;
      }
      std::vector<Sighting> sightings;
      static_cast<void>(memory->evaluator.Evaluate(std::span(&genes, 1), {count, std::span(&sightings, 1)}));
      return sightings;
    };
    return space;
  }

  /// One call at a time. @param genomes all that the search asked for
  [[nodiscard]] std::vector<Score> ScoresOf(std::span<const Genome> genomes) const {
    Watch watch;
    // Only a search that looks at motions pays for recording them, and only batches that wait for it are
    // small.
    if (memory_->count > 0 && genomes.size() <= Evaluator::kDefaultLanes) {
      memory_->genomes.assign(genomes.begin(), genomes.end());
      memory_->sightings.assign(genomes.size(), {});
      watch = {memory_->count, memory_->sightings};
    }
    std::vector<Score> scores;
    scores.reserve(genomes.size());
    for (const Evaluation& one : memory_->evaluator.Evaluate(genomes, watch)) scores.push_back(ScoreOf(one));
    return scores;
  }

  /// For threads that share what a search asked for.
  [[nodiscard]] const Evaluator& ForPieces() const { return memory_->evaluator; }

 private:
  struct Memory {
    explicit Memory(const Problem& problem) : evaluator(problem) {}
    Evaluator evaluator;
    int count = 0;  // of sightings that a search asked for; 0: it has not looked yet
    std::vector<Genome> genomes = {};
    std::vector<std::vector<Sighting>> sightings = {};
  };

  ControllerShape shape_;
  SenseSpec senses_;
  std::shared_ptr<Memory> memory_;
};

/// The controllers that a search of the problem tries. @param start its first genome; empty: random
[[nodiscard]] inline SearchSpace SpaceOf(const Problem& problem, Genome start = {}) {
  return Scorer(problem).Space(std::move(start));
}

}  // namespace gaitsmith
