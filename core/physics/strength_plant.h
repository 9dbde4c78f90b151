// SPDX-License-Identifier: MIT
// The second physical model: W articulated figures of one kind in one environment, whose joints are only as
// strong as their figure says. Satisfies the concept Plant of rollout/plant.h.
#pragma once

#include <array>

#include "core/physics/drawn_ground.h"
#include "core/physics/level_ground.h"
#include "core/physics/limb_guard.h"
#include "core/physics/limb_step.h"
#include "core/physics/motion_reports.h"
#include "core/physics/muscles.h"
#include "core/physics/snapshot.h"
#include "core/signal/readings.h"
#include "core/world/environment.h"

namespace gaitsmith {

template <int W>
class StrengthPlant {
  using L = Lane<W>;
  using F = typename L::F;

 public:
  static constexpr int kLanes = W;
  static constexpr int kModel = 2;
  using Body = Mechanism;
  using State = LimbState<W>;
  using LaneState = LimbState<1>;
  using Muscles = LimitedMuscles<W>;

  /// @param body must outlive the plant
  StrengthPlant(const Mechanism& body, const Environment& environment, const StartState& start, float step_s)
      : body_(body),
        environment_(environment),
        world_(body, environment, step_s),
        terrain_(environment.ground),
        guard_(body),
        start_turn_rad_(static_cast<double>(body.start_angle_rad)) {
    PlaceAtStart(start);
  }

  static PortCount CountPorts(const Figure& figure) { return {figure.Joints(), figure.Endpoints()}; }
  static Ports PortsOf(const Mechanism& body) { return gaitsmith::PortsOf(body); }

  [[nodiscard]] const LimbState<W>& Save() const { return state_; }
  void Restore(const LimbState<W>& state) {
    state_ = state;
    MeasureHeights();
  }
  void BeginAt(const LimbState<1>& state) {
    SpreadState<W>(state, state_);
    start_turn_rad_ = state.turn_rad[0];
    MeasureHeights();
  }

  void Give(const Push& push) {
    LimbState<W>& s = state_;
    s.velocity_x += L::Splat(push.impulse_x_ns * world_.inverse_mass);
    s.velocity_y += L::Splat(push.impulse_y_ns * world_.inverse_mass);
    if (push.endpoint == kCentreOfMass) return;
    const LimbArms<W> arms(body_, s.cosine, s.sine);
    LimbNumbers<W> up, along;
    arms.RowsOf(body_, static_cast<std::size_t>(push.endpoint), up, along);
    s.angular_momentum += up[0] * push.impulse_y_ns + along[0] * push.impulse_x_ns;
    for (std::size_t j = 1; j < static_cast<std::size_t>(body_.rods); ++j)
      s.momentum[j] += up[j] * push.impulse_y_ns + along[j] * push.impulse_x_ns;
  }

  void Step(int step, const ActuatorTargets<W>& targets) {
    if (environment_.sway_rad != 0.0f) {
      const float time_s = static_cast<float>(step) * world_.step_s;
      world_.Tilt(environment_.gravity_mps2, GroundAngle(environment_, time_s));
    }
    // Adding zero turns -0 into +0, so that impulses of zero change no bit.
    state_.velocity_x = state_.velocity_x + world_.fall_x + 0.0f;
    state_.velocity_y = state_.velocity_y + world_.fall_y + 0.0f;
    const typename LimbGuard<W>::Place before = guard_.PlaceOf(state_);
    if (terrain_.Level()) {
      LevelGround<W> ground(body_, world_, state_);
      LimbStep<W, LevelGround<W>>(body_, world_, targets, state_, ground).Conclude();
    } else {
      DrawnGround<W> ground(body_, world_, terrain_, state_);
      LimbStep<W, DrawnGround<W>>(body_, world_, targets, state_, ground).Conclude();
    }
    if (guard_.Judge(state_)) {
      guard_.Rest(before, state_);
      PlaceLimbs<W>(body_, state_);
    }
    MeasureHeights();
  }

  [[nodiscard]] Readings<W> Read() const {
    const LimbState<W>& s = state_;
    return {.position = s.angle_rad.data(),
            .rate = s.rate_radps.data(),
            .change = s.joint_turn.data(),
            .impulse = s.last_force.normal.data(),
            .height = terrain_.Level() ? &s.height_m : &height_m_,
            .rise = &s.velocity_y,
            .terrain = terrain_.Level() ? nullptr : &terrain_,
            .place = &s.place_m};
  }
  [[nodiscard]] F Upright() const {
    F sine, cosine;
    SinCosOfTurn<W>(state_.turn_rad - static_cast<double>(body_.start_angle_rad), sine, cosine);
    return cosine;
  }
  [[nodiscard]] F HeadHeight() const {
    return terrain_.Level() ? state_.height_m + state_.endpoint_y[static_cast<std::size_t>(body_.head)]
                            : head_height_m_;
  }

  [[nodiscard]] Snapshot Observe(int lane) const {
    const LimbState<W>& s = state_;
    return {s.distance_m[lane],      s.height_m[lane],         s.velocity_x[lane],    s.velocity_y[lane],
            s.turn_rad[lane],        s.angular_momentum[lane], s.normal_work_j[lane], s.friction_work_j[lane],
            s.friction_gain_j[lane], s.lifting_work_j[lane]};
  }
  [[nodiscard]] std::array<float, 2> ContactPoint(int contact, int lane) const {
    const auto k = static_cast<std::size_t>(contact);
    return {state_.endpoint_x[k][lane], state_.endpoint_y[k][lane]};
  }
  [[nodiscard]] std::array<float, 2> ContactForce(int contact, int lane) const {
    const auto k = static_cast<std::size_t>(contact);
    return {state_.last_force.tangent[k][lane] / world_.step_s,
            state_.last_force.normal[k][lane] / world_.step_s};
  }

  /// The part of its greatest torque that a joint's muscles gave in the last step, [0, 1].
  [[nodiscard]] float Strain(int joint, int lane) const {
    const auto i = static_cast<std::size_t>(joint) + 1;
    const float most = body_.torque_nm[i] * world_.step_s;
    if (most == 0.0f || L::At(state_.stop_side[i], lane) != 0.0f) return 0.0f;
    const float share = L::At(state_.joint_impulse[i], lane) / most;
    return share < 0.0f ? -share : share;
  }

  [[nodiscard]] Terms TermsOf(int lane) const { return gaitsmith::TermsOf(state_, lane, start_turn_rad_); }

  void AddTo(TrajectoryHash& hash, int lane) const { AddPositions(body_, state_, lane, hash); }

 private:
  void PlaceAtStart(const StartState& start) {
    LimbState<W>& s = state_;
    s.velocity_x = L::Splat(start.velocity_x_mps);
    s.velocity_y = L::Splat(start.velocity_y_mps);
    s.turn_rad = L::ToDouble(L::Splat(body_.start_angle_rad));
    PlaceLimbs<W>(body_, s);
    s.speed[0] = L::Splat(start.spin_radps);
    LimbInertia<W> inertia;
    MeasureMass<W>(body_, s.cosine, s.sine, inertia);
    s.momentum = inertia.Momenta(static_cast<std::size_t>(body_.rods), s.speed);
    s.angular_momentum = s.momentum[0];
    const LimbPlaces places = PlacesOf(s, static_cast<std::size_t>(body_.endpoints), 0);
    const auto lift = static_cast<float>(SpotFinder(body_, terrain_).LiftOf(places));
    s.height_m = s.start_height_m = s.greatest_height_m = L::Splat(start.drop_height_m + lift);
    MeasureHeights();
  }

  /// Heights above drawn ground right below.
  void MeasureHeights() {
    if (terrain_.Level()) return;
    const LimbState<W>& s = state_;
    const auto head = static_cast<std::size_t>(body_.head);
    for (int lane = 0; lane < W; ++lane) {
      const double x = s.place_m[lane];
      const double head_x = x + static_cast<double>(s.endpoint_x[head][lane]);
      height_m_[lane] = s.height_m[lane] - static_cast<float>(terrain_.HeightAt(x));
      head_height_m_[lane] =
          s.height_m[lane] + s.endpoint_y[head][lane] - static_cast<float>(terrain_.HeightAt(head_x));
    }
  }

  const Mechanism& body_;
  Environment environment_;
  World world_;
  Terrain terrain_;
  LimbGuard<W> guard_;
  LimbState<W> state_;
  F height_m_{}, head_height_m_{};  // above drawn ground
  double start_turn_rad_;           // of the root rod
};

}  // namespace gaitsmith
