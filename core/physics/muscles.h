// SPDX-License-Identifier: MIT
// What the muscles of figures did in a step, for measuring their work: known in model 2, found by inverse
// dynamics in model 1. Joint limits are no muscles: what they do is left out.
#pragma once

#include <array>
#include <span>

#include "core/physics/inverse_dynamics.h"
#include "core/physics/motion_state.h"

namespace gaitsmith {

/// The muscles of model 1.
template <int W>
class PrescribedMuscles {
  using L = Lane<W>;
  using F = typename L::F;

 public:
  /// What is remembered from step to step: momenta beyond the joints [kg m^2/s].
  using Memory = LimbNumbers<W>;

  PrescribedMuscles(const Skeleton& skeleton, float step_s) : body_(skeleton), inverse_(body_, step_s) {}
  PrescribedMuscles(const PrescribedMuscles&) = delete;
  PrescribedMuscles& operator=(const PrescribedMuscles&) = delete;

  /// Call before the first step.
  [[nodiscard]] Memory Begin(const MotionState<W>& s) const {
    return inverse_.MomentaAt({s.turn_rad, s.angle_rad}, s.rate_radps, s.angular_momentum);
  }
  /// Call after every step. @param pushes just before it @return impulse of each joint's muscles [N m s]
  [[nodiscard]] std::array<F, kMaxActuators> ImpulsesOf(const MotionState<W>& s, std::span<const Push> pushes,
                                                        Memory& memory) const {
    const LimbNumbers<W> all = inverse_.ImpulsesOf(
        {{s.turn_rad, s.angle_rad}, s.spin, s.joint_turn, s.last_normal, s.last_tangent, pushes}, memory);
    std::array<F, kMaxActuators> muscles{};
    for (std::size_t j = 0; j < static_cast<std::size_t>(body_.joints); ++j) {
      const Skeleton::Limb& limb = body_.limbs[j + 1];
      // A joint at its limit is held there, and pushed back by the limit.
      const auto held = ((s.angle_rad[j] == limb.max_rad) & (all[j + 1] < 0.0f)) |
                        ((s.angle_rad[j] == limb.min_rad) & (all[j + 1] > 0.0f));
      muscles[j] = L::Select(held, F{}, all[j + 1]);
    }
    return muscles;
  }

 private:
  Mechanism body_;
  InverseDynamics<W> inverse_;
};

/// The muscles of model 2.
template <int W>
class LimitedMuscles {
  using L = Lane<W>;
  using F = typename L::F;

 public:
  struct Memory {};  // nothing is remembered

  LimitedMuscles(const Mechanism& body, float /*step_s*/) : joints_(static_cast<std::size_t>(body.joints)) {}

  [[nodiscard]] Memory Begin(const LimbState<W>& /*state*/) const { return {}; }
  /// As above.
  [[nodiscard]] std::array<F, kMaxActuators> ImpulsesOf(const LimbState<W>& s,
                                                        std::span<const Push> /*pushes*/,
                                                        Memory& /*memory*/) const {
    std::array<F, kMaxActuators> muscles{};
    for (std::size_t j = 0; j < joints_; ++j)
      muscles[j] = L::Select(s.stop_side[j + 1] == 0.0f, s.joint_impulse[j + 1], F{});
    return muscles;
  }

 private:
  std::size_t joints_;
};

}  // namespace gaitsmith
