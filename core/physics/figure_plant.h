// SPDX-License-Identifier: MIT
// The first physical model, frozen: W articulated figures of one kind in one environment. The joints follow
// their targets with whatever torque that takes. Satisfies the concept Plant of rollout/plant.h.
#pragma once

#include <array>

#include "core/physics/ground.h"
#include "core/physics/motion_reports.h"
#include "core/physics/muscles.h"
#include "core/physics/snapshot.h"
#include "core/signal/readings.h"
#include "core/world/environment.h"

namespace gaitsmith {

template <int W>
class FigurePlant {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;

 public:
  static constexpr int kLanes = W;
  static constexpr int kModel = 1;
  using Body = Skeleton;
  using State = MotionState<W>;
  using LaneState = MotionState<1>;
  using Muscles = PrescribedMuscles<W>;

  /// @param skeleton must outlive the plant
  FigurePlant(const Skeleton& skeleton, const Environment& environment, const StartState& start, float step_s)
      : skeleton_(skeleton),
        environment_(environment),
        world_(skeleton, environment, step_s),
        start_turn_rad_(static_cast<double>(skeleton.start_angle_rad)) {
    PlaceAtStart(start);
  }

  static PortCount CountPorts(const Figure& figure) { return {figure.Joints(), figure.Endpoints()}; }
  static Ports PortsOf(const Skeleton& skeleton) { return gaitsmith::PortsOf(skeleton); }

  void Restore(const MotionState<W>& state) { state_ = state; }
  void BeginAt(const MotionState<1>& state) {
    SpreadState<W>(state, state_);
    start_turn_rad_ = state.turn_rad[0];
  }

  void Give(const Push& push) {
    MotionState<W>& s = state_;
    s.velocity_x += L::Splat(push.impulse_x_ns * world_.inverse_mass);
    s.velocity_y += L::Splat(push.impulse_y_ns * world_.inverse_mass);
    if (push.endpoint == kCentreOfMass) return;
    const auto k = static_cast<std::size_t>(push.endpoint);
    const Pose<W>& pose = s.PoseNow();
    const F arm_x = s.cosine * pose.endpoint_x[k] - s.sine * pose.endpoint_y[k];
    const F arm_y = s.sine * pose.endpoint_x[k] + s.cosine * pose.endpoint_y[k];
    s.angular_momentum += arm_x * push.impulse_y_ns - arm_y * push.impulse_x_ns;
  }

  void Step(int step, const ActuatorTargets<W>& targets) {
    if (environment_.sway_rad != 0.0f) {
      const float time_s = static_cast<float>(step) * world_.step_s;
      world_.Tilt(environment_.gravity_mps2, GroundAngle(environment_, time_s));
    }
    Fly<W>(skeleton_, world_, targets, state_);
    MeetGround<W>(skeleton_, world_, state_);
    Conclude();
  }

  [[nodiscard]] Readings<W> Read() const {
    const MotionState<W>& s = state_;
    return {.position = s.angle_rad.data(),
            .rate = s.rate_radps.data(),
            .change = s.joint_turn.data(),
            .impulse = s.last_normal.data(),
            .height = &s.height_m,
            .rise = &s.velocity_y};
  }

  /// Computed afresh, because the squares of the state's sine and cosine add up to 1 only within rounding. A
  /// figure that has not turned is upright to the bit.
  [[nodiscard]] F Upright() const {
    F sine, cosine;
    SinCosOfTurn<W>(state_.turn_rad - static_cast<double>(skeleton_.start_angle_rad), sine, cosine);
    return cosine;
  }
  [[nodiscard]] F HeadHeight() const {
    const Pose<W>& pose = state_.PoseNow();
    const auto head = static_cast<std::size_t>(skeleton_.head);
    return state_.height_m + (state_.sine * pose.endpoint_x[head] + state_.cosine * pose.endpoint_y[head]);
  }

  [[nodiscard]] Snapshot Observe(int lane) const {
    const MotionState<W>& s = state_;
    return {s.distance_m[lane],
            s.height_m[lane],
            s.velocity_x[lane],
            s.velocity_y[lane],
            s.turn_rad[lane],
            s.angular_momentum[lane],
            s.ground.normal_work_j[lane],
            s.ground.friction_work_j[lane],
            s.ground.friction_gain_j[lane],
            s.lifting_work_j[lane]};
  }
  [[nodiscard]] std::array<float, 2> ContactPoint(int contact, int lane) const {
    const MotionState<W>& s = state_;
    const auto k = static_cast<std::size_t>(contact);
    const float x = s.PoseNow().endpoint_x[k][lane], y = s.PoseNow().endpoint_y[k][lane];
    return {s.cosine[lane] * x - s.sine[lane] * y, s.sine[lane] * x + s.cosine[lane] * y};
  }
  [[nodiscard]] std::array<float, 2> ContactForce(int contact, int lane) const {
    const auto k = static_cast<std::size_t>(contact);
    return {state_.last_tangent[k][lane] / world_.step_s, state_.last_normal[k][lane] / world_.step_s};
  }

  [[nodiscard]] const MotionState<W>& Save() const { return state_; }

  [[nodiscard]] Terms TermsOf(int lane) const { return gaitsmith::TermsOf(state_, lane, start_turn_rad_); }

  /// Adds this step's positions of one figure to a hash.
  void AddTo(TrajectoryHash& hash, int lane) const { AddPositions(skeleton_, state_, lane, hash); }

 private:
  void PlaceAtStart(const StartState& start) {
    MotionState<W>& s = state_;
    PoseFigure<W>(skeleton_, s.angle_rad, s.poses[0]);
    const Pose<W>& pose = s.poses[0];
    s.velocity_x = L::Splat(start.velocity_x_mps);
    s.velocity_y = L::Splat(start.velocity_y_mps);
    s.shape = MeasureShape<W>(skeleton_, pose, pose, s.joint_turn, world_.inverse_step);
    s.angular_momentum = s.shape.inertia * start.spin_radps;
    s.spin = L::Splat(start.spin_radps);
    s.turn_rad = L::ToDouble(L::Splat(skeleton_.start_angle_rad));
    SinCosOfTurn<W>(s.turn_rad, s.sine, s.cosine);
    const auto height_of = [&](std::size_t k) {
      return s.sine * pose.endpoint_x[k] + s.cosine * pose.endpoint_y[k];
    };
    F lowest = height_of(0);
    for (std::size_t k = 1; k < static_cast<std::size_t>(skeleton_.endpoints); ++k) {
      lowest = L::Min(height_of(k), lowest);
    }
    s.height_m = s.start_height_m = s.greatest_height_m = L::Splat(start.drop_height_m) - lowest;
  }

  /// Makes the end of the step the state, and adds up what was measured in the step.
  [[gnu::noinline]] void Conclude() {
    MotionState<W>& s = state_;
    const auto endpoints = static_cast<std::size_t>(skeleton_.endpoints);
    s.velocity_x += s.ground.along * world_.inverse_mass;
    s.velocity_y += s.ground.up * world_.inverse_mass;
    s.angular_momentum += s.ground.moment;
    s.distance_m += L::ToDouble(s.path_x);
    // The direction is computed from the accumulated turn. A direction turned step by step would lose what is
    // below its rounding, and a figure at rest would count turns that it does not make.
    s.turn_rad += L::ToDouble(s.spin * world_.step_s);
    SinCosOfTurn<W>(s.turn_rad, s.sine, s.cosine);
    // Lifts a figure that still ends below the ground, by position alone, without changing its velocity.
    F lowest = s.endpoint_height[0];
    for (std::size_t k = 1; k < endpoints; ++k) lowest = L::Min(s.endpoint_height[k], lowest);
    const F lift = L::Max(-lowest, F{});
    s.height_m = s.height_m + s.path_y + lift;
    s.lifting_work_j = lift * world_.weight_n;
    s.greatest_height_m = L::Max(s.greatest_height_m, s.height_m);
    s.slip_m += s.ground.slip_m;
    // Written so that NaN also trips the guards.
    const F work = s.ground.normal_work_j + s.ground.friction_work_j + s.lifting_work_j;
    s.broken |= ~((lift <= kMaxPenetration) & (work <= world_.max_ground_work_j) &
                  (s.ground.given_energy_j + s.lifting_work_j <= world_.max_ground_work_j) &
                  (L::Abs(s.spin) * world_.step_s <= kMaxTurnPerStep) &
                  (L::Abs(s.foreseen_spin) * world_.step_s <= kMaxForeseenTurn));
    for (std::size_t k = 0; k < endpoints; ++k) {
      s.last_normal[k] = s.normal[k];
      s.last_tangent[k] = s.tangent[k];
      s.normal[k] = s.tangent[k] = F{};
    }
    s.now = 1 - s.now;
  }

  const Skeleton& skeleton_;
  Environment environment_;
  World world_;
  MotionState<W> state_;
  double start_turn_rad_;  // of the root rod
};

}  // namespace gaitsmith
