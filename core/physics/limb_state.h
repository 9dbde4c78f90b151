// SPDX-License-Identifier: MIT
// The state of W figures whose limbs move under forces (model 2): what carries over from step to step, and
// what is measured over the motion. Plain data.
#pragma once

#include <array>

#include "core/numeric/lane.h"
#include "core/physics/constants.h"

namespace gaitsmith {

/// The ground's impulses on all endpoints [N s].
template <int W>
struct EndpointImpulses {
  std::array<typename Lane<W>::F, kMaxEndpoints> normal{}, tangent{};
};

template <int W>
struct LimbState {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;
  using D = typename L::D;

  // Carried over. Momenta, not speeds, so that nothing is lost when the shape changes.
  D distance_m{};  // of the centre of mass along the ground
  F height_m{};    // of the centre of mass above the ground
  F velocity_x{}, velocity_y{};
  F angular_momentum{};  // about the centre of mass [kg m^2/s]
  D turn_rad{};          // of the root rod, whole turns included
  D place_m{};           // on drawn ground only: of the centre of mass, wherever measuring began
  std::array<F, kMaxJoints> angle_rad{};
  // As the joint's rule, or its freedom, leaves it at the end of a step.
  std::array<F, kMaxJoints> rate_radps{};
  // From index 1 on: of all limbs beyond a joint, about it [kg m^2/s].
  std::array<F, kMaxRods> momentum{};
  // Mean of the last step: of the root, then of each joint [rad/s].
  std::array<F, kMaxRods> speed{};
  // How the root turned back from each joint's turning in the last step.
  std::array<F, kMaxRods> root_answer{};
  std::array<F, kMaxRods> cosine{}, sine{};                 // of each rod's direction
  std::array<F, kMaxEndpoints> endpoint_x{}, endpoint_y{};  // from the centre of mass [m]
  std::array<F, kMaxRods> torque_side{};  // 0: the joint follows its rule; 1, -1: at its greatest torque
  std::array<F, kMaxRods> stop_side{};    // 1, -1: at its upper, lower limit; 0: at neither
  // Impulses of the ground in the last step [N s].
  EndpointImpulses<W> last_force;
  std::array<F, kMaxJoints> joint_turn{};   // in the last step [rad]
  std::array<F, kMaxRods> joint_impulse{};  // of the muscles and stops in the last step [N m s]

  // Measured over the motion.
  F start_height_m{}, greatest_height_m{}, slip_m{};
  I broken{};                                                                 // lanes whose motion is void
  F normal_work_j{}, friction_work_j{}, friction_gain_j{}, lifting_work_j{};  // of the last step
};

/// Copies one figure's state into every lane. Measuring starts from there. A void motion stays void.
template <int W>
void SpreadState(const LimbState<1>& one, LimbState<W>& all) {
  using L = Lane<W>;
  const auto spread = [](const auto& from, auto& to) {
    for (std::size_t i = 0; i < from.size(); ++i) to[i] = L::Splat(from[i][0]);
  };
  all = {};
  all.height_m = all.start_height_m = all.greatest_height_m = L::Splat(one.height_m[0]);
  all.velocity_x = L::Splat(one.velocity_x[0]);
  all.velocity_y = L::Splat(one.velocity_y[0]);
  all.place_m = one.place_m[0] - typename L::D{};
  all.angular_momentum = L::Splat(one.angular_momentum[0]);
  all.turn_rad = one.turn_rad[0] - typename L::D{};
  spread(one.angle_rad, all.angle_rad);
  spread(one.rate_radps, all.rate_radps);
  spread(one.momentum, all.momentum);
  spread(one.speed, all.speed);
  spread(one.root_answer, all.root_answer);
  spread(one.cosine, all.cosine);
  spread(one.sine, all.sine);
  spread(one.endpoint_x, all.endpoint_x);
  spread(one.endpoint_y, all.endpoint_y);
  spread(one.torque_side, all.torque_side);
  spread(one.stop_side, all.stop_side);
  spread(one.last_force.normal, all.last_force.normal);
  spread(one.last_force.tangent, all.last_force.tangent);
  if (one.broken[0] != 0) all.broken = ~typename L::I{};
}

}  // namespace gaitsmith
