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
#include "core/springs/drawn_floor.h"
#include "core/springs/level_floor.h"
#include "core/springs/spring_forces.h"
#include "core/springs/spring_muscles.h"

namespace gaitsmith {

/// A motion is void when a spring is longer than this many times its drawn length.
inline constexpr float kMostStretch = 10.0f;
/// A motion is void when nodes are deeper in drawn ground than this [m].
inline constexpr double kMostBuried = 0.02;
/// A figure whose nodes have come together to less than this share of its drawn moment of inertia keeps its
/// turn.
inline constexpr float kLeastSpread = 1e-6f;

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
    return {figure.Muscles(), static_cast<int>(figure.nodes.size())};
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
            s_.centre_velocity_y[lane], s_.turn_rad[lane],        AngularMomentum(lane),
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
    MeasureTurn();
    s_.broken |= ~(stretch <= kMostStretch);
    for (int lane = 0; lane < W; ++lane) {
      if (IsBuried(lane)) s_.broken[lane] = -1;
      if (s_.broken[lane] != 0 && !IsFinite(lane)) Rest(before, lane);
    }
  }

  /// The rotation of the drawn pose that fits the nodes best, by least squares with their masses as weights
  /// [Kabsch 1976].
  void MeasureTurn() {
    F along{}, across{};
    for (std::size_t k = 0; k < body_.nodes; ++k) {
      const float x = body_.mass_kg[k] * body_.drawn_x[k], y = body_.mass_kg[k] * body_.drawn_y[k];
      const F up = s_.y[k];
      along += x * s_.x[k] + y * up;
      across += x * up - y * s_.x[k];
    }
    const F norm = L::Sqrt(along * along + across * across);
    const I known = norm > kLeastSpread * body_.drawn_kgm2;
    const F inverse = 1.0f / L::Select(known, norm, L::Splat(1.0f));
    s_.cosine = L::Select(known, along * inverse, s_.cosine);
    s_.sine = L::Select(known, across * inverse, s_.sine);
    constexpr double kRound = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds to the nearest integer
    for (int lane = 0; lane < W; ++lane) {
      const double angle = static_cast<double>(Atan2(s_.sine[lane], s_.cosine[lane]));
      const double turns = ((s_.turn_rad[lane] - angle) * (0.5 / kPi) + kRound) - kRound;
      s_.turn_rad[lane] = angle + turns * (2.0 * kPi);
    }
  }

  [[nodiscard]] float AngularMomentum(int lane) const {
    float sum = 0.0f;
    for (std::size_t k = 0; k < body_.nodes; ++k) {
      const float x = s_.x[k][lane], y = s_.y[k][lane];
      const float speed_x = s_.velocity_x[k][lane] - s_.centre_velocity_x[lane];
      const float speed_y = s_.velocity_y[k][lane] - s_.centre_velocity_y[lane];
      sum += body_.mass_kg[k] * (x * speed_y - y * speed_x);
    }
    return sum;
  }

  [[nodiscard]] bool IsBuried(int lane) const {
    if (terrain_.Level()) return false;
    for (std::size_t k = 0; k < body_.nodes; ++k) {
      const double x = s_.place_m[lane] + static_cast<double>(s_.x[k][lane]);
      const double y =
          static_cast<double>(s_.height_m[lane]) + static_cast<double>(s_.y[k][lane]) + kMostBuried;
      if (y >= terrain_.HeightAt(x)) continue;
      // Right at a vertical face a node may be a rounding error to the wrong side.
      if (y < terrain_.HeightAt(x - kBehindFace) && y < terrain_.HeightAt(x + kBehindFace)) return true;
    }
    return false;
  }

  [[nodiscard]] bool IsFinite(int lane) const {
    // A sum is finite only if all of its numbers are.
    double sum = s_.distance_m[lane] + s_.turn_rad[lane];
    const auto add = [&](const F& number) { sum += static_cast<double>(L::At(number, lane)); };
    for (std::size_t k = 0; k < body_.nodes; ++k) {
      for (const F* number :
           {&s_.x[k], &s_.y[k], &s_.velocity_x[k], &s_.velocity_y[k], &s_.normal[k], &s_.tangent[k]})
        add(*number);
    }
    for (const F* number : {&s_.slip_m, &s_.normal_work_j, &s_.friction_work_j, &s_.lifting_work_j})
      add(*number);
    for (std::size_t j = 0; j < body_.muscles; ++j) {
      for (const F* number : {&s_.length[j], &s_.length_rate[j], &s_.work_j[j]}) add(*number);
    }
    return std::isfinite(sum);
  }

  /// Lets a figure that is not finite rest where it was.
  void Rest(const State& before, int lane) {
    const auto back = [lane](F& now, const F& then) { L::Put(now, lane, L::At(then, lane)); };
    const auto zero = [lane](F& now) { L::Put(now, lane, 0.0f); };
    for (std::size_t k = 0; k < body_.nodes; ++k) {
      back(s_.x[k], before.x[k]);
      back(s_.y[k], before.y[k]);
      for (F* number : {&s_.velocity_x[k], &s_.velocity_y[k], &s_.normal[k], &s_.tangent[k]}) zero(*number);
    }
    for (std::size_t j = 0; j < body_.muscles; ++j) {
      back(s_.length[j], before.length[j]);
      zero(s_.length_rate[j]);
      zero(s_.work_j[j]);
    }
    s_.distance_m[lane] = before.distance_m[lane];
    s_.place_m[lane] = before.place_m[lane];
    s_.turn_rad[lane] = before.turn_rad[lane];
    for (auto part :
         {&State::cosine, &State::sine, &State::height_m, &State::greatest_height_m, &State::slip_m})
      back(s_.*part, before.*part);
    for (auto part : {&State::centre_velocity_x, &State::centre_velocity_y, &State::normal_work_j,
                      &State::friction_work_j, &State::friction_gain_j, &State::lifting_work_j})
      zero(s_.*part);
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
