// SPDX-License-Identifier: MIT
// What a controller would do if it took over at other moments, while what goes before it goes on until then.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/rollout/problem.h"

namespace gaitsmith {

/// Moments have places: every 16th comes first, then those in the middle between them, and so on, so that a
/// part of the map is soon a picture of the whole. @return for each place the index of a moment
[[nodiscard]] std::vector<int> CoarseFirst(int count);

class MomentScorer;

class TransitionMap {
 public:
  /// @param problem of the controller that takes over, with exactly one beginning, whose steps do not matter;
  /// the task says how long it is watched @param genome of that controller
  /// @param steps at which it could take over, ascending, each in [0, kMaxSteps]
  TransitionMap(const Problem& problem, const Genome& genome, std::span<const int> steps);
  /// With a plant that no document can name: a PlantMomentScorer of it.
  TransitionMap(std::shared_ptr<const MomentScorer> scorer, int moments);

  /// Moments.
  [[nodiscard]] int Count() const { return static_cast<int>(order_.size()); }
  /// Simulates. @param first,count places within Count()
  /// @return of each what the task gives for what follows from there; kVoidScore where physics breaks.
  /// It does not depend on how the places are dealt out
  [[nodiscard]] std::vector<float> Scores(int first, int count) const;
  /// What the controller reaches in that time from the problem's start, without pushes: what scores are
  /// measured by.
  [[nodiscard]] float UsualScore() const { return usual_; }

 private:
  std::shared_ptr<const MomentScorer> scorer_;
  std::vector<int> order_;  // of each place
  float usual_;
};

}  // namespace gaitsmith
