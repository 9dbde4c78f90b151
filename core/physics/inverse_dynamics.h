// SPDX-License-Identifier: MIT
// Which impulses the joints of W figures must have given, so that they moved as they did. The equations are
// those of limb_step.h, solved for the impulses: with the mean speeds w of a step, mass matrix M and bias b
// at mid-step, the momenta beyond the joints are M w - h b / 2 before the motion and M w + h b / 2 after it.
// What a step adds between the end of the last one and its own beginning came from joints, ground and pushes.
#pragma once

#include <array>
#include <span>

#include "core/physics/limb_arms.h"
#include "core/world/environment.h"

namespace gaitsmith {

template <int W>
class InverseDynamics {
  using L = Lane<W>;
  using F = typename L::F;

 public:
  InverseDynamics(const Mechanism& body, float step_s)
      : body_(body), step_s_(step_s), rods_(static_cast<std::size_t>(body.rods)) {}

  /// A figure at one instant, as any model knows it.
  struct Instant {
    typename L::D turn_rad;  // direction of the root rod
    const std::array<F, kMaxJoints>& angle_rad;
  };

  /// The momenta beyond the joints [kg m^2/s] of a figure that moves as a whole with this angular momentum.
  /// @param rate_radps of each joint
  [[nodiscard]] LimbNumbers<W> MomentaAt(const Instant& now, const std::array<F, kMaxJoints>& rate_radps,
                                         const F& angular_momentum) const {
    LimbNumbers<W> cosine, sine, speed;
    Direct(now, cosine, sine);
    LimbInertia<W> inertia;
    MeasureMass<W>(body_, cosine, sine, inertia);
    F of_joints{};
    for (std::size_t i = 1; i < rods_; ++i) {
      speed[i] = rate_radps[i - 1];
      of_joints += inertia.mass[i][0] * speed[i];
    }
    speed[0] = (angular_momentum - of_joints) / inertia.mass[0][0];
    return inertia.Momenta(rods_, speed);
  }

  /// What a figure did in a step, and what acted on it.
  struct Step {
    Instant end;
    const F& root_speed;                                  // mean [rad/s]
    const std::array<F, kMaxJoints>& joint_turn;          // [rad]
    const std::array<F, kMaxEndpoints>&normal, &tangent;  // of level ground [N s]
    std::span<const Push> pushes;                         // just before it
  };

  /// @param momentum beyond each joint; in: at the end of the step before, out: of this step
  /// @return impulse of each joint, muscles and limits together, by its outer limb [N m s]. The number of the
  /// root is what is not explained: rounding, and arms that the ground's impulses were predicted with
  [[nodiscard]] LimbNumbers<W> ImpulsesOf(const Step& step, LimbNumbers<W>& momentum) const {
    LimbNumbers<W> cosine, sine, speed;
    Direct(step.end, cosine, sine);
    speed[0] = step.root_speed;
    for (std::size_t i = 1; i < rods_; ++i) speed[i] = step.joint_turn[i - 1] * (1.0f / step_s_);
    const LimbNumbers<W> turning = TurningOf<W>(body_, speed);
    TurnAll(-0.5f * step_s_, turning, cosine, sine);
    LimbInertia<W> inertia;
    MeasureMass<W>(body_, cosine, sine, inertia);
    MeasureBias<W>(body_, cosine, sine, turning, inertia);
    const LimbNumbers<W> momenta = inertia.Momenta(rods_, speed);
    LimbNumbers<W> given{};
    const LimbArms<W> arms(body_, cosine, sine);
    for (std::size_t k = 0; k <= rods_; ++k) AddForce(arms, k, step.normal[k], step.tangent[k], given);
    if (!step.pushes.empty()) {
      // They act before the figure moves.
      TurnAll(-0.5f * step_s_, turning, cosine, sine);
      const LimbArms<W> before(body_, cosine, sine);
      for (const Push& push : step.pushes) {
        if (push.endpoint == kCentreOfMass) continue;
        AddForce(before, static_cast<std::size_t>(push.endpoint), L::Splat(push.impulse_y_ns),
                 L::Splat(push.impulse_x_ns), given);
      }
    }
    LimbNumbers<W> impulse;
    for (std::size_t i = 0; i < rods_; ++i) {
      const F half = 0.5f * step_s_ * inertia.bias[i];
      impulse[i] = (momenta[i] - half) - momentum[i] - given[i];
      momentum[i] = momenta[i] + half;
    }
    return impulse;
  }

 private:
  /// The rods' directions.
  void Direct(const Instant& at, LimbNumbers<W>& cosine, LimbNumbers<W>& sine) const {
    SinCosOfTurn<W>(at.turn_rad, sine[0], cosine[0]);
    for (std::size_t a = 1; a < rods_; ++a) {
      const auto parent = static_cast<std::size_t>(body_.limbs[a].parent);
      F turned_sine, turned_cosine;
      SinCos<W>(at.angle_rad[a - 1] + body_.limbs[a].rest_rad, turned_sine, turned_cosine);
      cosine[a] = cosine[parent] * turned_cosine - sine[parent] * turned_sine;
      sine[a] = sine[parent] * turned_cosine + cosine[parent] * turned_sine;
    }
  }
  void TurnAll(float time_s, const LimbNumbers<W>& turning, LimbNumbers<W>& cosine,
               LimbNumbers<W>& sine) const {
    for (std::size_t a = 0; a < rods_; ++a) Turn<W>(time_s * turning[a], sine[a], cosine[a]);
  }
  void AddForce(const LimbArms<W>& arms, std::size_t endpoint, const F& up, const F& along,
                LimbNumbers<W>& momenta) const {
    LimbNumbers<W> row_n, row_t;
    arms.RowsOf(body_, endpoint, row_n, row_t);
    for (std::size_t i = 0; i < rods_; ++i) momenta[i] += row_n[i] * up + row_t[i] * along;
  }

  const Mechanism& body_;
  float step_s_;
  std::size_t rods_;
};

}  // namespace gaitsmith
