// SPDX-License-Identifier: MIT
// The ground's part of a step: which endpoints of each figure touch, which impulses they get, and where that
// leaves the figure.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "core/physics/contact_sweeps.h"
#include "core/physics/flight.h"

namespace gaitsmith {

/// W figures with up to Slots contacts each. The endpoint behind a contact can differ from figure to figure.
template <int W, std::size_t Slots>
class Touch {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;

 public:
  /// @param endpoints bit mask per lane, 0 in lanes that take no part
  Touch(const World& world, const MotionState<W>& s, const I& endpoints, std::size_t contacts)
      : world_(world), contacts_(contacts) {
    I left = endpoints;
    for (std::size_t c = 0; c < contacts; ++c) {
      present_[c] = left != 0;
      const I lowest = left & -left;
      // The exponent of a power of two is the number of its bit.
      const I number = ((reinterpret_cast<I>(__builtin_convertvector(lowest, F)) >> 23) - 127) & present_[c];
      for (int lane = 0; lane < W; ++lane)
        number_[c][static_cast<std::size_t>(lane)] =
            static_cast<std::size_t>(number[lane]) * W + static_cast<std::size_t>(lane);
      left ^= lowest;
    }
    // Forces act in the middle of the step, at the positions known so far.
    body_ = {s.velocity_x,    s.velocity_y,     s.flight_spin, s.height_m + 0.5f * s.path_y,
             s.shape.inertia, s.inverse_inertia};
    F sine = s.sine, cosine = s.cosine;
    Turn<W>(0.5f * world.step_s * s.spin, sine, cosine);
    for (std::size_t c = 0; c < contacts; ++c) {
      const F x0 = Each(c, s.PoseNow().endpoint_x), y0 = Each(c, s.PoseNow().endpoint_y);
      const F x1 = Each(c, s.NextPose().endpoint_x), y1 = Each(c, s.NextPose().endpoint_y);
      last_normal_[c] = Each(c, s.last_normal);
      const F r_x = 0.5f * (x0 + x1), r_y = 0.5f * (y0 + y1);
      const F u_x = (x1 - x0) * world.inverse_step, u_y = (y1 - y0) * world.inverse_step;
      Contact<W>& contact = contact_[c];
      // The arm of an absent contact may be infinite, and zero force times infinity is not zero. Absent
      // contacts therefore get arm 0.
      contact.arm = L::Select(present_[c], cosine * r_x - sine * r_y, F{});
      // An endpoint that lands during this step is not quite at height 0 at mid-step.
      const F above = body_.height + (sine * r_x + cosine * r_y);
      contact.drift_t = (cosine * u_x - sine * u_y) - s.spin * above;
      const F gap = s.height_m + (s.sine * x0 + s.cosine * y0);
      const F drift_n = (sine * u_x + cosine * u_y) + L::Max(gap, F{}) * world.inverse_step;
      contact.drift_n = L::Select(present_[c], drift_n, L::Splat(kOutOfReach));
    }
  }

  void Solve(const MotionState<W>& s) {
    if constexpr (Slots == 1) {
      SolveSingle<W>(world_, body_, contact_[0]);
    } else if constexpr (Slots == 2) {
      SolvePair<W>(world_, body_, contact_[0], contact_[1], present_[1]);
    } else {
      // If two feet are driven apart, friction climbs to the edge of its cone by one step's worth per sweep.
      // So the sweeps start from the friction of the last step.
      for (std::size_t c = 0; c < contacts_; ++c) {
        contact_[c].force = {L::Select(present_[c], last_normal_[c], F{}),
                             L::Select(present_[c], Each(c, s.last_tangent), F{})};
      }
      SolveMany<W>(world_, body_, std::span(contact_).first(contacts_), present_);
    }
  }

  /// Writes the impulses to the state in the given lanes.
  void Tell(const I& lanes, MotionState<W>& s) const {
    Body<W> body = body_;
    GroundEffect<W> effect;
    for (std::size_t c = 0; c < contacts_; ++c) {
      const Contact<W>& contact = contact_[c];
      effect.up += contact.force.normal;
      effect.along += contact.force.tangent;
      effect.moment += contact.force.normal * contact.arm + contact.force.tangent * body.height;
      body.Push(world_, contact.arm, contact.force);
    }
    for (std::size_t c = 0; c < contacts_; ++c) {
      const Contact<W>& contact = contact_[c];
      const F slide = contact.Slide(body);
      const I bears = (contact.force.normal > 0.0f) & (last_normal_[c] > 0.0f);
      effect.slip_m += L::Select(bears, L::Abs(slide) * world_.step_s, F{});
      effect.normal_work_j += contact.force.normal * contact.Approach(body);
      const F work = contact.force.tangent * slide;
      effect.friction_work_j += work;
      effect.friction_gain_j += L::Max(work, F{});
    }
    s.ground.up = L::Select(lanes, effect.up, s.ground.up);
    s.ground.along = L::Select(lanes, effect.along, s.ground.along);
    s.ground.moment = L::Select(lanes, effect.moment, s.ground.moment);
    s.ground.slip_m = L::Select(lanes, effect.slip_m, s.ground.slip_m);
    s.ground.normal_work_j = L::Select(lanes, effect.normal_work_j, s.ground.normal_work_j);
    s.ground.friction_work_j = L::Select(lanes, effect.friction_work_j, s.ground.friction_work_j);
    s.ground.friction_gain_j = L::Select(lanes, effect.friction_gain_j, s.ground.friction_gain_j);
    for (std::size_t c = 0; c < contacts_; ++c) {
      // Absent contacts write back what is there.
      const I takes = lanes & present_[c];
      Put(c, L::Select(takes, contact_[c].force.normal, Each(c, s.normal)), s.normal);
      Put(c, L::Select(takes, contact_[c].force.tangent, Each(c, s.tangent)), s.tangent);
    }
  }

 private:
  /// The drift of an absent contact [m/s], so large that it never reaches the ground.
  static constexpr float kOutOfReach = 1e6f;

  /// Gathers each lane's own endpoint of a contact from an array over endpoints.
  [[nodiscard]] F Each(std::size_t contact, const std::array<F, kMaxEndpoints>& numbers) const {
    const auto* first = reinterpret_cast<const float*>(numbers.data());
    F all;
    for (int lane = 0; lane < W; ++lane) all[lane] = first[number_[contact][static_cast<std::size_t>(lane)]];
    return all;
  }
  /// Scatters each lane's number to its own endpoint.
  void Put(std::size_t contact, const F& all, std::array<F, kMaxEndpoints>& numbers) const {
    auto* first = reinterpret_cast<float*>(numbers.data());
    for (int lane = 0; lane < W; ++lane) first[number_[contact][static_cast<std::size_t>(lane)]] = all[lane];
  }

  const World& world_;
  std::size_t contacts_;
  // Index of each lane's endpoint in an array over endpoints, counted in floats. Absent contacts use endpoint
  // 0.
  std::array<std::array<std::size_t, W>, Slots> number_;
  std::array<I, Slots> present_;
  Body<W> body_;
  std::array<Contact<W>, Slots> contact_;
  std::array<F, Slots> last_normal_;
};

/// Solves the contacts of each lane.
/// @param endpoints bit mask per lane of the endpoints that touch, 0 in lanes that take no part
template <int W>
void SolveTouching(const World& world, MotionState<W>& s, const typename Lane<W>::I& endpoints) {
  using I = typename Lane<W>::I;
  const I after_one = endpoints & (endpoints - 1), after_two = after_one & (after_one - 1);
  const I few = (endpoints != 0) & (after_two == 0), many = after_two != 0;
  if (Lane<W>::Any(few & (after_one != 0))) {
    Touch<W, 2> touch(world, s, endpoints & few, 2);
    touch.Solve(s);
    touch.Tell(few, s);
  } else if (Lane<W>::Any(few)) {
    Touch<W, 1> touch(world, s, endpoints & few, 1);
    touch.Solve(s);
    touch.Tell(few, s);
  }
  if (!Lane<W>::Any(many)) return;
  int most = 0;
  for (int lane = 0; lane < W; ++lane) {
    if (many[lane] != 0) most = std::max(most, std::popcount(static_cast<std::uint32_t>(endpoints[lane])));
  }
  Touch<W, kMaxEndpoints> touch(world, s, endpoints & many, static_cast<std::size_t>(most));
  touch.Solve(s);
  touch.Tell(many, s);
}

/// Measures the energy that the ground's impulses add in a step [J]: their work at the mean of the velocities
/// before and after them. This equals the work at the velocities after them, less half of the velocity change
/// they cause. It is measured along the endpoints' actual paths, not the predicted ones. If contacts were
/// solved exactly, it would never be positive. It is computed only in lanes where much energy is exchanged.
/// In most steps little is exchanged, so little can be gained.
template <int W>
void MeasureGivenEnergy(const Skeleton& skeleton, const World& world, MotionState<W>& s) {
  using L = Lane<W>;
  using F = typename L::F;
  const F kick_x = s.ground.along + world.mass_kg * world.fall_x;
  const F kick_y = s.ground.up + world.mass_kg * world.fall_y;
  const F changed = 0.5f * ((kick_x * kick_x + kick_y * kick_y) * world.inverse_mass +
                            s.ground.moment * s.ground.moment * s.inverse_inertia);
  // Work of normal forces and of friction are added as magnitudes, so that they cannot cancel. So is friction
  // on the error of its lever, which was predicted in free fall: a figure of a millimetre falls far in a step
  // compared with its size.
  const F lever = 0.5f * (s.flight_y - s.path_y);
  const F went_by = changed + L::Abs(s.ground.normal_work_j) + L::Abs(s.ground.friction_work_j) +
                    L::Abs(s.ground.along * s.spin * lever);
  const typename L::I much = (s.ground.up > 0.0f) & (went_by > world.max_ground_work_j);
  if (!L::Any(much)) return;
  const Pose<W>& before = s.PoseNow();
  const Pose<W>& after = s.NextPose();
  F along{}, up{}, moment{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(skeleton.endpoints); ++k) {
    const F x = s.cosine * before.endpoint_x[k] - s.sine * before.endpoint_y[k];
    const F y = s.height_m + (s.sine * before.endpoint_x[k] + s.cosine * before.endpoint_y[k]);
    const F next_x = s.next_cosine * after.endpoint_x[k] - s.next_sine * after.endpoint_y[k];
    along += s.tangent[k] * (s.path_x + (next_x - x));
    up += s.normal[k] * (s.endpoint_height[k] - y);
    const F arm_y = 0.5f * (y + s.endpoint_height[k] - s.path_y) - s.height_m;
    moment += s.normal[k] * (0.5f * (x + next_x)) - s.tangent[k] * arm_y;
  }
  // If the arms were predicted wrongly, the angular momentum adds energy that no endpoint received.
  const F astray = s.spin * (s.ground.moment - moment);
  s.ground.given_energy_j = L::Select(much, (along + up) * world.inverse_step - changed + astray, F{});
}

/// Applies the ground to the figures that would end the step near it.
template <int W>
[[gnu::noinline]] void MeetGround(const Skeleton& skeleton, const World& world, MotionState<W>& s) {
  using L = Lane<W>;
  using I = typename L::I;
  I endpoints = EndpointsNearGround<W>(skeleton, s);
  if (!L::Any(endpoints != 0)) return;
  I known = endpoints;
  for (int round = 1; L::Any(endpoints != 0); ++round) {
    s.foreseen_spin = L::Select(endpoints != 0, s.spin, s.foreseen_spin);
    SolveTouching<W>(world, s, endpoints);
    const typename L::F guess = s.spin;
    PlaceAtEnd<W>(skeleton, world, s);
    if (round == kContactRounds) break;
    // A landing may throw further endpoints against the ground, and turn the contact arms.
    const I touched = s.ground.up > 0.0f;
    const I near = known | (touched & EndpointsNearGround<W>(skeleton, s));
    const I turned = touched & (L::Abs(s.spin - guess) * world.step_s > kArmTurn);
    endpoints = ((near != known) | turned) & near;
    known = near;
  }
  MeasureGivenEnergy<W>(skeleton, world, s);
}

}  // namespace gaitsmith
