// SPDX-License-Identifier: MIT
// How a controller would score if it took over at other moments, while the clips before it continue until
// then.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/rollout/problem.h"

namespace gaitsmith {

/// An order of moments from coarse to fine: every 16th first, then the moments halfway between those, and so
/// on. An unfinished map therefore already covers the whole range.
/// @return the index of a moment for each place in the order
[[nodiscard]] std::vector<int> CoarseFirst(int count);

class MomentScorer;

class TransitionMap {
 public:
  /// @param problem of the controller that takes over, with exactly one beginning. Its number of steps is not
  /// used. The task gives the duration of each score
  /// @param genome of that controller
  /// @param steps at which it could take over, ascending, each in [0, kMaxSteps]
  TransitionMap(const Problem& problem, const Genome& genome, std::span<const int> steps);
  /// With a PlantMomentScorer, for a plant that is not a model of documents.
  TransitionMap(std::shared_ptr<const MomentScorer> scorer, int moments);

  /// Number of moments.
  [[nodiscard]] int Count() const { return static_cast<int>(order_.size()); }
  /// Simulates the moments at some places in the order.
  /// @param first,count places within Count()
  /// @return the task's score from each moment on; kVoidScore if the motion breaks physics. The result does
  /// not depend on how places are divided into calls
  [[nodiscard]] std::vector<float> Scores(int first, int count) const;
  /// The controller's score from the problem's start, without pushes. Other scores are compared with it.
  [[nodiscard]] float UsualScore() const { return usual_; }

 private:
  std::shared_ptr<const MomentScorer> scorer_;
  std::vector<int> order_;  // moment at each place in the order
  float usual_;
};

}  // namespace gaitsmith
