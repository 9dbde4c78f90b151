// SPDX-License-Identifier: MIT
// The state of W figures side by side: what carries over from step to step, what is measured over the motion,
// and the step in progress. Plain data, used by flight.h, ground.h and figure_plant.h.
#pragma once

#include <array>

#include "core/physics/contact.h"
#include "core/physics/pose.h"

namespace gaitsmith {

/// The ground's effect on W figures in one step.
template <int W>
struct GroundEffect {
  using F = typename Lane<W>::F;
  F along{}, up{};    // sum of impulses [N s]
  F moment{};         // about the centre of mass [N m s]
  F slip_m{};         // path of endpoints that bear load in this step and in the step before
  F normal_work_j{};  // by normal forces
  F friction_work_j{};
  F friction_gain_j{};  // the part by contacts where friction did positive work, which it never should
  F given_energy_j{};   // by all impulses along the endpoints' actual paths: see MeasureGivenEnergy
};

template <int W>
struct MotionState {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;
  using D = typename L::D;

  // Carried over from step to step. The state holds momentum, not spin: see flight.h.
  D distance_m{};  // of the centre of mass along the ground
  F height_m{};    // of the centre of mass above the ground
  F velocity_x{}, velocity_y{};
  F angular_momentum{};  // about the centre of mass [kg m^2/s]
  D turn_rad{};          // of the root rod, whole turns included
  F sine{}, cosine{};    // of turn_rad
  std::array<F, kMaxJoints> angle_rad{}, rate_radps{};
  std::array<Pose<W>, 2> poses{};  // [now]: the present pose; the other one: at the end of the step
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
  F flight_x{}, flight_y{};      // displacement of the centre of mass without the ground [m]
  F path_x{}, path_y{};          // displacement of the centre of mass as known so far [m]
  F flight_spin{}, spin{};       // of the root rod, without the ground and as known so far [rad/s]
  F next_sine{}, next_cosine{};  // of the root rod at the end of the step, as known so far
  std::array<F, kMaxEndpoints> endpoint_height{};
  std::array<F, kMaxEndpoints> normal{}, tangent{};  // impulses in this step [N s]
  GroundEffect<W> ground{};
  F lifting_work_j{};
  F foreseen_spin{};  // predicted spin that the contact arms were computed with [rad/s]

  [[nodiscard]] const Pose<W>& PoseNow() const { return poses[static_cast<std::size_t>(now)]; }
  [[nodiscard]] const Pose<W>& NextPose() const { return poses[static_cast<std::size_t>(1 - now)]; }
  [[nodiscard]] Pose<W>& NextPose() { return poses[static_cast<std::size_t>(1 - now)]; }
};

/// Copies one figure's state into every lane, with its joint rates and contact impulses. Measuring starts
/// from there. A void motion stays void.
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
