// SPDX-License-Identifier: MIT
#include "core/physics/motion.h"

#include "core/physics/evaluator.h"
#include "core/physics/simulation.h"

namespace gaitsmith {

Motion::Motion(const Figure& figure, const Environment& environment, const StartState& start,
               std::span<const Push> pushes, std::span<const Controller> controllers,
               std::span<const Clip> clips, int steps, float step_s)
    : skeleton_(figure), step_s_(step_s), senses_per_frame_(SenseCount(SenseKind::kPhysical, figure.Rods())) {
  const auto limits = JointLimits(skeleton_);
  std::vector<Bank<1>> banks;
  banks.reserve(clips.size());
  for (const Clip& clip : clips) {
    const Controller& controller = controllers[static_cast<std::size_t>(clip.controller)];
    const std::span<const Gene> genes(controller.genes);
    banks.emplace_back(BankShape(controller.rules, controller.senses.kind, figure.Rods()), controller.senses,
                       std::span(&genes, 1), limits, step_s);
  }

  Simulation<1> simulation(skeleton_, environment, start, pushes, step_s);
  TrajectoryHash hash;
  int clip = -1;
  const auto record = [&] {
    const auto work = simulation.WorkOf(0);
    frames_.push_back({simulation.DistanceM(0), simulation.HeightM(0), simulation.VelocityXMps(0),
                       simulation.VelocityYMps(0), simulation.TurnRad(0), simulation.AngularMomentum(0),
                       work.normal_j, work.friction_j, work.friction_gain_j, work.lifting_j, clip,
                       simulation.Rule(0)});
    terms_.push_back(simulation.TermsOf(0));
    for (int k = 0; k < skeleton_.endpoints; ++k) {
      endpoints_.push_back({simulation.EndpointX(0, k), simulation.EndpointY(0, k)});
      forces_.push_back({simulation.TangentForceN(0, k), simulation.NormalForceN(0, k)});
    }
    for (int j = 0; j < skeleton_.joints; ++j) {
      angles_.push_back(simulation.AngleRad(0, j));
      rates_.push_back(simulation.RateRadps(0, j));
    }
    for (int s = 0; s < senses_per_frame_; ++s) senses_.push_back(simulation.SenseValue(0, s));
  };

  const auto take_over = [&](int step) {
    while (clip + 1 < static_cast<int>(clips.size()) &&
           clips[static_cast<std::size_t>(clip) + 1].start_step <= step) {
      ++clip;
      simulation.Follow(banks[static_cast<std::size_t>(clip)]);
    }
  };
  take_over(0);
  record();
  for (int step = 0; step < steps; ++step) {
    take_over(step);
    simulation.Step();
    simulation.AddTo(hash, 0);
    record();
  }
  hash_ = hash.Value();
}

}  // namespace gaitsmith
