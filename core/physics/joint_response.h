// SPDX-License-Identifier: MIT
// How joints follow a controller.
#pragma once

#include <array>

#include "core/numeric/scalar_math.h"
#include "core/physics/skeleton.h"
#include "core/signal/actuator_targets.h"

namespace gaitsmith {

/// What an actuator follows, as in ActuatorTargets.
template <int W>
struct FollowedTarget {
  const typename Lane<W>::F &target, &decay, &inverse_tau;
};

/// Advances an actuator by one step, critically damped,
///   theta'' = (target - theta) / tau^2 - 2 theta' / tau,
/// in closed form: with e = theta - target and A = theta' + e / tau,
///   theta <- target + (e + A h) exp(-h / tau)      theta' <- (theta' - A h / tau) exp(-h / tau).
/// One that reaches its limit stops there. Without limits it would overshoot by several radians when a fast
/// rule hands over to a slow one.
/// @param position, rate  in and out [rad], [rad/s] for joints
/// @return change of position in this step
template <int W>
[[gnu::always_inline]] inline typename Lane<W>::F FollowTarget(const FollowedTarget<W>& followed,
                                                               float step_s, float least, float greatest,
                                                               typename Lane<W>::F& position,
                                                               typename Lane<W>::F& rate) {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;
  const F off = position - followed.target;
  const F pull_step = (rate + off * followed.inverse_tau) * step_s;
  const F free_position = followed.target + (off + pull_step) * followed.decay;
  const F free_rate = (rate - pull_step * followed.inverse_tau) * followed.decay;
  const I below = free_position < least;
  const I above = free_position > greatest;
  const F held = L::Select(below, L::Splat(least), L::Select(above, L::Splat(greatest), free_position));
  const F change = held - position;
  position = held;
  rate = L::Select(below | above | (L::Abs(free_rate) < kRestRate), F{}, free_rate);
  return change;
}

/// Advances all joints by one step. Stopping at a limit does not change the figure's momentum.
/// @param angle, rate  of each joint [rad], [rad/s]; in and out
/// @param turn         out: change of each angle in this step [rad]
template <int W>
void MoveJoints(const Skeleton& skeleton, const ActuatorTargets<W>& targets, float step_s,
                std::array<typename Lane<W>::F, kMaxJoints>& angle,
                std::array<typename Lane<W>::F, kMaxJoints>& rate,
                std::array<typename Lane<W>::F, kMaxJoints>& turn) {
  for (std::size_t j = 0; j < static_cast<std::size_t>(skeleton.joints); ++j) {
    const Skeleton::Limb& limb = skeleton.limbs[j + 1];
    turn[j] = FollowTarget<W>({targets.target[j], targets.decay[j], targets.inverse_tau[j]}, step_s,
                              limb.min_rad, limb.max_rad, angle[j], rate[j]);
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
