// SPDX-License-Identifier: MIT
// A step as it would be without the ground. Controllers prescribe the joint angles, so at every instant a
// figure is one rigid body of changing shape with three unknown velocities. The state holds momentum, not
// velocity. Free flight therefore conserves linear and angular momentum exactly, whatever the joints do
// (docs/physics.md derives every line).
//
//   L = J phi' + H      J(q) = sum m |r|^2 + m l^2 / 12      H(q, q') = sum m (r x u) + (m l^2 / 12) w
//
// J and H are taken at mid-step from the poses before and after the step: r = (r0 + r1) / 2, u = (r1 - r0) /
// h. One pose per step thus serves both the dynamics (second order in flight) and the contacts, for which it
// is exact up to the square of the angle turned in a step.
#pragma once

#include "core/physics/joint_response.h"
#include "core/physics/motion_state.h"
#include "core/physics/world.h"

namespace gaitsmith {

/// Places the figures at the end of the step, given the ground's effect as known so far.
template <int W>
void PlaceAtEnd(const Skeleton& skeleton, const World& world, MotionState<W>& s) {
  using L = Lane<W>;
  using F = typename L::F;
  // Impulses change L directly, and the spin is derived from L, so that rounding errors do not accumulate in
  // both.
  s.spin = (s.angular_momentum + s.ground.moment - s.shape.momentum) * s.inverse_inertia;
  const auto touched = s.ground.up > 0.0f;
  s.path_x =
      L::Select(touched, world.step_s * (s.velocity_x + s.ground.along * world.inverse_mass), s.flight_x);
  s.path_y = L::Select(touched, world.step_s * (s.velocity_y + s.ground.up * world.inverse_mass), s.flight_y);
  s.next_sine = s.sine;
  s.next_cosine = s.cosine;
  Turn<W>(s.spin * world.step_s, s.next_sine, s.next_cosine);
  const F height = s.height_m + s.path_y;
  const Pose<W>& pose = s.NextPose();
  for (std::size_t k = 0; k < static_cast<std::size_t>(skeleton.endpoints); ++k) {
    s.endpoint_height[k] = height + (s.next_sine * pose.endpoint_x[k] + s.next_cosine * pose.endpoint_y[k]);
  }
}

/// Bit mask of the endpoints that would end the step near the ground or below it.
template <int W>
typename Lane<W>::I EndpointsNearGround(const Skeleton& skeleton, const MotionState<W>& s) {
  typename Lane<W>::I near{};
  for (int k = 0; k < skeleton.endpoints; ++k) {
    near |= (s.endpoint_height[static_cast<std::size_t>(k)] < kContactMargin) & (1 << k);
  }
  return near;
}

/// Computes gravity, joints and the path of a step without the ground.
template <int W>
[[gnu::noinline]] void Fly(const Skeleton& skeleton, const World& world, const ActuatorTargets<W>& targets,
                           MotionState<W>& s) {
  // Adding zero turns -0 into +0, so that impulses of zero change no bit.
  s.velocity_x = s.velocity_x + world.fall_x + 0.0f;
  s.velocity_y = s.velocity_y + world.fall_y + 0.0f;
  MoveJoints<W>(skeleton, targets, world.step_s, s.angle_rad, s.rate_radps, s.joint_turn);
  PoseFigure<W>(skeleton, s.angle_rad, s.NextPose());
  s.shape = MeasureShape<W>(skeleton, s.PoseNow(), s.NextPose(), s.joint_turn, world.inverse_step);
  s.inverse_inertia = 1.0f / s.shape.inertia;
  // The path follows the mean velocity, so that free fall is exact.
  s.flight_x = world.step_s * (s.velocity_x - 0.5f * world.fall_x);
  s.flight_y = world.step_s * (s.velocity_y - 0.5f * world.fall_y);
  s.ground = {};
  PlaceAtEnd<W>(skeleton, world, s);
  s.flight_spin = s.foreseen_spin = s.spin;
}

}  // namespace gaitsmith
