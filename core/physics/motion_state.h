// SPDX-License-Identifier: MIT
// Everything about W figures side by side: what they carry from step to step, what is measured over their
// motion, and the step in progress. Plain data; flight.h, ground.h and simulation.h work on it.
#pragma once

#include <array>

#include "core/control/bank.h"
#include "core/control/network.h"
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
  I rule{};  // of a bank
  Response<W> response{};
  SenseVector<W> senses{};
  NetworkState<W> network{};

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

  [[nodiscard]] const Pose<W>& PoseNow() const { return poses[static_cast<std::size_t>(now)]; }
  [[nodiscard]] const Pose<W>& NextPose() const { return poses[static_cast<std::size_t>(1 - now)]; }
  [[nodiscard]] Pose<W>& NextPose() { return poses[static_cast<std::size_t>(1 - now)]; }
};

}  // namespace gaitsmith
