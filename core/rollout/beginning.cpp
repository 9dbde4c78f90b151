// SPDX-License-Identifier: MIT
#include "core/rollout/beginning.h"

#include "core/physics/simulation.h"
#include "core/rollout/evaluator.h"

namespace gaitsmith {

std::vector<Moment<1>> MomentsDuring(const Beginning& beginning, const Problem& problem,
                                     const Skeleton& skeleton, std::span<const int> steps) {
  Simulation<1> simulation(skeleton, problem.environment, problem.start, problem.pushes);
  const auto limits = JointLimits(skeleton);
  std::vector<Controllers<1>> decoded;
  for (const Controller& controller : beginning.controllers) {
    const std::span<const Gene> genes(controller.genes);
    decoded.push_back(DecodeControllers<1>(controller.Shape(skeleton.rods), controller.senses,
                                           std::span(&genes, 1), limits, kStep));
  }
  std::vector<Moment<1>> moments;
  moments.reserve(steps.size());
  std::size_t next = 0;
  int step = 0;
  for (const int wanted : steps) {
    for (; step < wanted; ++step) {
      for (; next < beginning.clips.size() && beginning.clips[next].start_step <= step; ++next)
        simulation.Follow(decoded[static_cast<std::size_t>(beginning.clips[next].controller)]);
      simulation.Step();
    }
    moments.push_back(simulation.Save());
  }
  return moments;
}

}  // namespace gaitsmith
