// SPDX-License-Identifier: MIT
// What controllers request from the actuators, lane by lane.
#pragma once

#include <array>

#include "core/numeric/lane.h"
#include "core/signal/ports.h"

namespace gaitsmith {

/// A target for each actuator, and the time constant tau with which the actuator approaches it. Without a
/// controller all values are zero, and the figure holds its drawn pose.
template <int W>
struct ActuatorTargets {
  using F = typename Lane<W>::F;
  std::array<F, kMaxActuators> target;       // in the unit of the actuator's position, [rad] for joints
  std::array<F, kMaxActuators> decay;        // exp(-h / tau), h the time step
  std::array<F, kMaxActuators> inverse_tau;  // [1/s]
};

}  // namespace gaitsmith
