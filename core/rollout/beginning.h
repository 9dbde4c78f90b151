// SPDX-License-Identifier: MIT
// The state of the plant during and after a beginning.
#pragma once

#include <span>
#include <vector>

#include "core/rollout/rollout.h"

namespace gaitsmith {

/// Simulates a beginning and saves moments of it.
/// @param problem its own beginnings are not used
/// @param body of the problem's figure
/// @param steps since the start, ascending; the beginning continues until the last of them
/// @return one moment for each step
template <template <int> class PlantOf>
[[nodiscard]] std::vector<Moment<PlantOf, 1>> MomentsDuring(const Beginning& beginning,
                                                            const Problem& problem,
                                                            const typename PlantOf<1>::Body& body,
                                                            std::span<const int> steps) {
  const auto takeovers =
      DecodeClips(beginning.clips, beginning.controllers, PlantOf<1>::PortsOf(body), kStep);
  Rollout<PlantOf, 1> rollout(body, problem.environment, problem.start, problem.pushes, takeovers);
  std::vector<Moment<PlantOf, 1>> moments;
  moments.reserve(steps.size());
  for (const int step : steps) {
    rollout.RunTo(step, kNothing, kNothing);
    moments.push_back(rollout.Save());
  }
  return moments;
}

}  // namespace gaitsmith
