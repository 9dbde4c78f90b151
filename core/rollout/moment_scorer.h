// SPDX-License-Identifier: MIT
// Scores a controller from moments of a beginning, with the plant of one model. TransitionMap chooses the
// plant.
#pragma once

#include <span>
#include <vector>

#include "core/rollout/beginning.h"
#include "core/rollout/measurement.h"

namespace gaitsmith {

class MomentScorer {
 public:
  virtual ~MomentScorer() = default;
  /// The task's score of the controller from a moment on. @param moment index of its step
  [[nodiscard]] virtual float ScoreFrom(int moment) const = 0;
  /// The task's score from the problem's start, without pushes.
  [[nodiscard]] virtual float UsualScore() const = 0;
};

template <template <int> class PlantOf>
class PlantMomentScorer final : public MomentScorer {
 public:
  /// Takes the same parameters as TransitionMap.
  PlantMomentScorer(const Problem& problem, const Genome& genome, std::span<const int> steps)
      : problem_(problem),
        body_(problem.figure),
        ports_(PlantOf<1>::PortsOf(body_)),
        controllers_(Decoded(problem, ports_, genome)),
        moments_(MomentsDuring<PlantOf>(problem.beginnings.front(), problem, body_, steps)) {}

  [[nodiscard]] float ScoreFrom(int moment) const override {
    Rollout<PlantOf, 1> rollout(body_, problem_.environment, problem_.start, problem_.pushes);
    rollout.BeginAt(moments_[static_cast<std::size_t>(moment)]);
    return Fitness(rollout);
  }
  [[nodiscard]] float UsualScore() const override {
    Rollout<PlantOf, 1> rollout(body_, problem_.environment, problem_.start, {});
    return Fitness(rollout);
  }

 private:
  static Controllers<1> Decoded(const Problem& problem, const Ports& ports, const Genome& genome) {
    const std::span<const Gene> genes(genome);
    return DecodeControllers<1>(problem.ShapeFor(ports.Count()), problem.senses, std::span(&genes, 1), ports,
                                kStep);
  }

  [[nodiscard]] float Fitness(Rollout<PlantOf, 1>& rollout) const {
    rollout.Follow(controllers_);
    Evaluation evaluation;
    Measure(rollout, body_, ports_, problem_.task, std::span(&evaluation, 1));
    return evaluation.fitness;
  }

  Problem problem_;
  typename PlantOf<1>::Body body_;
  Ports ports_;
  Controllers<1> controllers_;
  std::vector<Moment<PlantOf, 1>> moments_;  // ascending
};

}  // namespace gaitsmith
