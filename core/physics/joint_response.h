// SPDX-License-Identifier: MIT
// How joints follow a controller.
#pragma once

#include <array>

#include "core/numeric/scalar_math.h"
#include "core/physics/skeleton.h"
#include "core/signal/actuator_targets.h"

namespace gaitsmith {

/// Advances all joints by one step, critically damped,
///   theta'' = (target - theta) / tau^2 - 2 theta' / tau,
/// in closed form: with e = theta - target and A = theta' + e / tau,
///   theta <- target + (e + A h) exp(-h / tau)      theta' <- (theta' - A h / tau) exp(-h / tau).
/// A joint that reaches its limit stops there. Without limits it would overshoot by several radians when a
/// fast rule hands over to a slow one. Stopping does not change the figure's momentum.
/// @param angle, rate  of each joint [rad], [rad/s]; in and out
/// @param turn         out: change of each angle in this step [rad]
template <int W>
void MoveJoints(const Skeleton& skeleton, const ActuatorTargets<W>& targets, float step_s,
                std::array<typename Lane<W>::F, kMaxJoints>& angle,
                std::array<typename Lane<W>::F, kMaxJoints>& rate,
                std::array<typename Lane<W>::F, kMaxJoints>& turn) {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;
  for (std::size_t j = 0; j < static_cast<std::size_t>(skeleton.joints); ++j) {
    const Skeleton::Limb& limb = skeleton.limbs[j + 1];
    const F off = angle[j] - targets.target[j];
    const F pull_step = (rate[j] + off * targets.inverse_tau[j]) * step_s;
    const F free_angle = targets.target[j] + (off + pull_step) * targets.decay[j];
    const F free_rate = (rate[j] - pull_step * targets.inverse_tau[j]) * targets.decay[j];
    const I below = free_angle < limb.min_rad;
    const I above = free_angle > limb.max_rad;
    const F held =
        L::Select(below, L::Splat(limb.min_rad), L::Select(above, L::Splat(limb.max_rad), free_angle));
    turn[j] = held - angle[j];
    angle[j] = held;
    rate[j] = L::Select(below | above | (L::Abs(free_rate) < kRestRate), F{}, free_rate);
  }
}

/// One joint without limits, in double precision.
struct FreeJoint {
  double angle_rad = 0.0, rate_radps = 0.0;

  /// One step, as MoveJoints.
  void Advance(double target_rad, double tau_s) {
    const auto step_s = static_cast<double>(kStep);
    const double off = angle_rad - target_rad, pull = (rate_radps + off / tau_s) * step_s,
                 decay = Exp(-step_s / tau_s);
    angle_rad = target_rad + (off + pull) * decay;
    rate_radps = (rate_radps - pull / tau_s) * decay;
  }
  /// The target that leads to an angle after a time.
  [[nodiscard]] double TargetFor(double wanted_rad, double after_s, double tau_s) const {
    const double decay = Exp(-after_s / tau_s), kept = (1.0 + after_s / tau_s) * decay;
    return (wanted_rad - angle_rad * kept - rate_radps * after_s * decay) / (1.0 - kept);
  }
};

}  // namespace gaitsmith
