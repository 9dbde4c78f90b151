// SPDX-License-Identifier: MIT
// Figures of model 2 and what their joints are asked for, shared by the tests of its laws.
#pragma once

#include <cstdint>
#include <span>

#include "core/numeric/scalar_math.h"
#include "core/physics/figure.h"
#include "core/signal/actuator_targets.h"

namespace gaitsmith::test {

/// A random tree with this number of rods. They are 0.3 to 1.2 m long and weigh 0.2 to 2 kg; the rest angles
/// are random, and each joint can turn by 1.5 rad to each side.
[[nodiscard]] Figure RandomTree(std::uint64_t seed, int rods, float strength, float stiffness = 10000.0f);

/// Targets that every lane's joints follow with one time constant. @param target_rad of each joint
template <int W>
ActuatorTargets<W> Towards(std::span<const float> target_rad, float tau_s, float step_s = kStep) {
  ActuatorTargets<W> targets{};
  for (std::size_t j = 0; j < target_rad.size(); ++j) {
    targets.target[j] = Lane<W>::Splat(target_rad[j]);
    targets.decay[j] = Lane<W>::Splat(static_cast<float>(Exp(-static_cast<double>(step_s / tau_s))));
    targets.inverse_tau[j] = Lane<W>::Splat(1.0f / tau_s);
  }
  return targets;
}

}  // namespace gaitsmith::test
