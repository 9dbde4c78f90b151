// SPDX-License-Identifier: MIT
// Everything about W figures side by side: what they carry from step to step, what is measured over their
// motion, and the step in progress. Plain data; flight.h, ground.h and figure_plant.h work on it.
#pragma once

#include <array>

#include "core/physics/contact.h"
#include "core/physics/pose.h"

namespace gaitsmith {

/// What the ground did to W figures in a step.
template <int W>
struct GroundEffect {
  using F = typename Lane<W>::F;
  F along{}, up{};    // sum of impulses [N s]
  F moment{};         // about the centre of mass [N m s]
  F slip_m{};         // way of endpoints that bear load now and did a step before
  F normal_work_j{};  // by normal forces
  F friction_work_j{};
  F friction_gain_j{};  // of that, by contacts where it had the wrong sign
  F given_energy_j{};   // by all, as the endpoints then really went: see MeasureGivenEnergy
};

template <int W>
struct MotionState {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;
  using D = typename L::D;

  // Carried from step to step. The state holds momentum, not spin: see flight.h.
  D distance_m{};  // of the centre of mass along the ground
  F height_m{};    // of the centre of mass above it
  F velocity_x{}, velocity_y{};
  F angular_momentum{};  // about the centre of mass [kg m^2/s]
  D turn_rad{};          // of the root rod, whole turns included
  F sine{}, cosine{};    // of turn_rad
  std::array<F, kMaxJoints> angle_rad{}, rate_radps{};
  std::array<Pose<W>, 2> poses{};  // [now] as it is, the other one at the end of the step in progress
  int now = 0;
  std::array<F, kMaxEndpoints> last_normal{};  // impulses of the ground in the last step [N s]
  std::array<F, kMaxEndpoints> last_tangent{};

  // Measured over the motion.
  F start_height_m{}, greatest_height_m{}, slip_m{};
  I broken{};  // lanes whose motion is void

  // The step in progress.
  std::array<F, kMaxJoints> joint_turn{};  // [rad]
  Shape<W> shape{};
  F inverse_inertia{};
  F flight_x{}, flight_y{};      // way of the centre of mass if no ground is met [m]
  F path_x{}, path_y{};          // and as known by now
  F flight_spin{}, spin{};       // of the root rod, likewise [rad/s]
  F next_sine{}, next_cosine{};  // at the end of the step, as known by now
  std::array<F, kMaxEndpoints> endpoint_height{};
  std::array<F, kMaxEndpoints> normal{}, tangent{};  // impulses in this step [N s]
  GroundEffect<W> ground{};
  F lifting_work_j{};
  F foreseen_spin{};  // with which the arms of the contacts were computed [rad/s]

  [[nodiscard]] const Pose<W>& PoseNow() const { return poses[static_cast<std::size_t>(now)]; }
  [[nodiscard]] const Pose<W>& NextPose() const { return poses[static_cast<std::size_t>(1 - now)]; }
  [[nodiscard]] Pose<W>& NextPose() { return poses[static_cast<std::size_t>(1 - now)]; }
};

/// Puts every lane where one figure is, its joint rates and what its endpoints bear included, and measures
/// from there. What is void stays so.
template <int W>
void SpreadState(const MotionState<1>& one, MotionState<W>& all) {
  using L = Lane<W>;
  const auto spread = [](const auto& from, auto& to) {
    for (std::size_t i = 0; i < from.size(); ++i) to[i] = L::Splat(from[i][0]);
  };
  all = {};
  all.height_m = all.start_height_m = all.greatest_height_m = L::Splat(one.height_m[0]);
  all.velocity_x = L::Splat(one.velocity_x[0]);
  all.velocity_y = L::Splat(one.velocity_y[0]);
  all.angular_momentum = L::Splat(one.angular_momentum[0]);
  all.turn_rad = one.turn_rad[0] - typename L::D{};
  all.sine = L::Splat(one.sine[0]);
  all.cosine = L::Splat(one.cosine[0]);
  all.spin = L::Splat(one.spin[0]);
  spread(one.angle_rad, all.angle_rad);
  spread(one.rate_radps, all.rate_radps);
  const Pose<1>& pose = one.PoseNow();
  spread(pose.endpoint_x, all.poses[0].endpoint_x);
  spread(pose.endpoint_y, all.poses[0].endpoint_y);
  spread(pose.middle_x, all.poses[0].middle_x);
  spread(pose.middle_y, all.poses[0].middle_y);
  spread(one.last_normal, all.last_normal);
  spread(one.last_tangent, all.last_tangent);
  if (one.broken[0] != 0) all.broken = ~typename L::I{};
}

}  // namespace gaitsmith
