// SPDX-License-Identifier: MIT
// The third physical model: W figures of point masses and springs of one kind in one environment [Christensen
// Marks Ngo 1997]. Satisfies the concept Plant of rollout/plant.h.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/physics/motion_reports.h"
#include "core/physics/snapshot.h"
#include "core/signal/readings.h"
#include "core/springs/best_rotation.h"
#include "core/springs/drawn_floor.h"
#include "core/springs/lattice_guard.h"
#include "core/springs/level_floor.h"
#include "core/springs/spring_forces.h"
#include "core/springs/spring_muscles.h"

namespace gaitsmith {

template <int W>
class SpringPlant {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;

 public:
  static constexpr int kLanes = W;
  static constexpr int kModel = 3;
  using Body = Lattice;
  using State = LatticeState<W>;
  using LaneState = LatticeState<1>;
  using Muscles = SpringMuscles<W>;

  /// @param body must outlive the plant
  SpringPlant(const Lattice& body, const Environment& environment, const StartState& start, float step_s)
      : body_(body),
        environment_(environment),
        world_(body, environment, step_s),
        step_s_(step_s),
        terrain_(environment.ground) {
    PlaceAtStart(start);
  }

  static PortCount CountPorts(const Figure& figure) {
    return {figure.Muscles(), static_cast<int>(figure.nodes.size()), true};
  }
  static Ports PortsOf(const Lattice& body) { return gaitsmith::PortsOf(body); }

  [[nodiscard]] const State& Save() const { return s_; }
  void Restore(const State& state) {
    s_ = state;
    MeasureHeights();
  }
  void BeginAt(const LaneState& state) {
    SpreadState<W>(state, s_);
    start_turn_rad_ = state.turn_rad[0];
    MeasureHeights();
  }

  /// An endpoint is a node.
  void Give(const Push& push) {
    if (push.endpoint == kCentreOfMass) {
      for (std::size_t k = 0; k < body_.nodes; ++k) {
        s_.velocity_x[k] += L::Splat(push.impulse_x_ns / body_.total_kg);
        s_.velocity_y[k] += L::Splat(push.impulse_y_ns / body_.total_kg);
      }
    } else {
      const auto k = static_cast<std::size_t>(push.endpoint);
      s_.velocity_x[k] += L::Splat(push.impulse_x_ns * body_.inverse_kg[k]);
      s_.velocity_y[k] += L::Splat(push.impulse_y_ns * body_.inverse_kg[k]);
    }
    s_.centre_velocity_x += push.impulse_x_ns / body_.total_kg;
    s_.centre_velocity_y += push.impulse_y_ns / body_.total_kg;
  }

  void Step(int step, const ActuatorTargets<W>& targets) {
    if (environment_.sway_rad != 0.0f)
      world_.Tilt(environment_.gravity_mps2, GroundAngle(environment_, static_cast<float>(step) * step_s_));
    const State before = s_;
    typename State::Points slide{};
    s_.normal = s_.tangent = {};
    s_.pulled_m = {};
    s_.normal_work_j = s_.friction_work_j = s_.friction_gain_j = s_.lifting_work_j = F{};
    MoveMuscles<W>(body_, targets, step_s_, s_);
    const F stretch = RunSubsteps(before, slide);
    Conclude(before, slide, stretch);
    MeasureHeights();
  }

  [[nodiscard]] Readings<W> Read() const {
    return {.position = s_.length.data(),
            .rate = s_.length_rate.data(),
            .change = s_.rest_change.data(),
            .impulse = s_.normal.data(),
            .height = terrain_.Level() ? &s_.height_m : &height_m_,
            .rise = &s_.centre_velocity_y,
            .terrain = terrain_.Level() ? nullptr : &terrain_,
            .place = &s_.place_m};
  }
  [[nodiscard]] F Upright() const { return s_.cosine; }
  [[nodiscard]] F HeadHeight() const {
    return terrain_.Level() ? s_.height_m + s_.y[body_.head] : head_height_m_;
  }

  [[nodiscard]] Snapshot Observe(int lane) const {
    return {s_.distance_m[lane],        s_.height_m[lane],        s_.centre_velocity_x[lane],
            s_.centre_velocity_y[lane], s_.turn_rad[lane],        AngularMomentum<W>(body_, s_, lane),
            s_.normal_work_j[lane],     s_.friction_work_j[lane], s_.friction_gain_j[lane],
            s_.lifting_work_j[lane]};
  }
  [[nodiscard]] std::array<float, 2> ContactPoint(int contact, int lane) const {
    const auto k = static_cast<std::size_t>(contact);
    return {s_.x[k][lane], s_.y[k][lane]};
  }
  [[nodiscard]] std::array<float, 2> ContactForce(int contact, int lane) const {
    const auto k = static_cast<std::size_t>(contact);
    return {s_.tangent[k][lane] / step_s_, s_.normal[k][lane] / step_s_};
  }

  [[nodiscard]] Terms TermsOf(int lane) const { return gaitsmith::TermsOf(s_, lane, start_turn_rad_); }

  void AddTo(TrajectoryHash& hash, int lane) const {
    hash.Add(s_.distance_m[lane]);
    for (std::size_t k = 0; k < body_.nodes; ++k) {
      hash.Add(s_.x[k][lane]);
      hash.Add(s_.y[k][lane]);
    }
    for (std::size_t j = 0; j < body_.muscles; ++j) hash.Add(s_.rest[j][lane]);
  }

 private:
  void PlaceAtStart(const StartState& start) {
    double lift = -1e9;
    for (std::size_t k = 0; k < body_.nodes; ++k) {
      const auto x = static_cast<double>(body_.drawn_x[k]), y = static_cast<double>(body_.drawn_y[k]);
      lift = std::max(lift, terrain_.HeightAt(x) - y);
    }
    const auto height = static_cast<float>(lift) + start.drop_height_m;
    for (std::size_t k = 0; k < body_.nodes; ++k) {
      const float x = body_.drawn_x[k], y = body_.drawn_y[k];
      s_.x[k] = L::Splat(x);
      s_.y[k] = L::Splat(y);
      s_.velocity_x[k] = L::Splat(start.velocity_x_mps - start.spin_radps * y);
      s_.velocity_y[k] = L::Splat(start.velocity_y_mps + start.spin_radps * x);
    }
    for (std::size_t j = 0; j < body_.muscles; ++j)
      s_.rest[j] = L::Splat(body_.link[body_.muscle[j].link].rest);
    StepBackHalf();
    s_.centre_velocity_x = L::Splat(start.velocity_x_mps);
    s_.centre_velocity_y = L::Splat(start.velocity_y_mps);
    s_.height_m = s_.start_height_m = s_.greatest_height_m = L::Splat(height);
    s_.cosine = L::Splat(1.0f);
    for (std::size_t j = 0; j < body_.muscles; ++j) s_.length[j] = L::Splat(1.0f);
    MeasureHeights();
  }

  /// Velocities half a substep before the positions, so that the motion is of second order from its start.
  void StepBackHalf() {
    State pulled = s_;
    PullSprings<W>(body_, world_, 0.0f, pulled);
    for (std::size_t k = 0; k < body_.nodes; ++k) {
      s_.velocity_x[k] = 0.5f * ((3.0f * s_.velocity_x[k] - pulled.velocity_x[k]) - world_.fall_x);
      s_.velocity_y[k] = 0.5f * ((3.0f * s_.velocity_y[k] - pulled.velocity_y[k]) - world_.fall_y);
    }
  }

  /// Rests change evenly within a step. Each substep pulls with those of the positions that it begins with.
  [[gnu::noinline]] F RunSubsteps(const State& before, typename State::Points& slide) {
    const typename State::Muscles end = s_.rest;
    F stretch{};
    for (int substep = 0; substep < world_.substeps; ++substep) {
      const float past = static_cast<float>(substep) * world_.substep_share;
      for (std::size_t j = 0; j < body_.muscles; ++j) s_.rest[j] = before.rest[j] + s_.rest_change[j] * past;
      stretch = L::Max(PullSprings<W>(body_, world_, substep == 0 ? 0.5f : 1.0f, s_), stretch);
      if (terrain_.Level())
        MoveOnFloor<W>(body_, world_, slide, s_);
      else
        MoveOnDrawnFloor<W>(body_, world_, terrain_, slide, s_);
    }
    s_.rest = end;
    return stretch;
  }

  [[gnu::noinline]] void Conclude(const State& before, const typename State::Points& slide,
                                  const F& stretch) {
    const float inverse_kg = 1.0f / body_.total_kg, rate = 1.0f / step_s_;
    F way{}, rise{}, speed_x{}, speed_y{};
    I bears{};
    for (std::size_t k = 0; k < body_.nodes; ++k) {
      const float mass = body_.mass_kg[k];
      way += mass * s_.x[k];
      rise += mass * s_.y[k];
      speed_x += mass * s_.velocity_x[k];
      speed_y += mass * s_.velocity_y[k];
      const I borne = s_.normal[k] > 0.0f;
      bears |= borne;
      s_.slip_m += L::Select(borne & (before.normal[k] > 0.0f), slide[k], F{});
      s_.normal[k] = L::Max(s_.normal[k], F{});
    }
    way = way * inverse_kg;
    rise = rise * inverse_kg;
    for (std::size_t k = 0; k < body_.nodes; ++k) {
      s_.x[k] -= way;
      s_.y[k] -= rise;
    }
    s_.height_m += rise;
    s_.distance_m += L::ToDouble(way);
    s_.place_m += L::ToDouble(way);
    // In flight the other half of gravity brings velocities to the time of the positions.
    s_.centre_velocity_x = speed_x * inverse_kg + L::Select(bears, F{}, L::Splat(0.5f * world_.fall_x));
    s_.centre_velocity_y = speed_y * inverse_kg + L::Select(bears, F{}, L::Splat(0.5f * world_.fall_y));
    s_.greatest_height_m = L::Max(s_.greatest_height_m, s_.height_m);
    for (std::size_t j = 0; j < body_.muscles; ++j) {
      const Lattice::Link& link = body_.link[body_.muscle[j].link];
      const F x = s_.x[link.to] - s_.x[link.from], y = s_.y[link.to] - s_.y[link.from];
      s_.length[j] = L::Sqrt((x * x + y * y) + kLeastSquaredLength) * (1.0f / link.drawn_m);
      s_.length_rate[j] = (s_.length[j] - before.length[j]) * rate;
      const F beyond = s_.pulled_m[j] + 0.5f * ((s_.length[j] - s_.rest[j]) * link.drawn_m);
      s_.work_j[j] = (-link.stiffness_npm * link.drawn_m * world_.substep_share) * s_.rest_change[j] * beyond;
    }
    MeasureTurn<W>(body_, s_);
    JudgeLattice<W>(body_, terrain_, stretch, (way + rise) + (speed_x + speed_y), before, s_);
  }

  /// Heights above drawn ground right below.
  void MeasureHeights() {
    if (terrain_.Level()) return;
    for (int lane = 0; lane < W; ++lane) {
      const double x = s_.place_m[lane];
      const double head_x = x + static_cast<double>(s_.x[body_.head][lane]);
      height_m_[lane] = s_.height_m[lane] - static_cast<float>(terrain_.HeightAt(x));
      head_height_m_[lane] =
          s_.height_m[lane] + s_.y[body_.head][lane] - static_cast<float>(terrain_.HeightAt(head_x));
    }
  }

  const Lattice& body_;
  Environment environment_;
  LatticeWorld world_;
  float step_s_;
  Terrain terrain_;
  State s_;
  F height_m_{}, head_height_m_{};  // above drawn ground
  double start_turn_rad_ = 0.0;
};

}  // namespace gaitsmith
