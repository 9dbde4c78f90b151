// SPDX-License-Identifier: MIT
// W figures of one kind in one environment, each following its own controller, advanced step by step.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>

#include "core/control/controllers.h"
#include "core/physics/environment.h"
#include "core/physics/ground.h"
#include "core/physics/trajectory_hash.h"
#include "core/rollout/task.h"

namespace gaitsmith {

template <int W>
class Simulation {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;

 public:
  /// @param pushes sorted by step; must outlive the simulation, as must the skeleton
  Simulation(const Skeleton& skeleton, const Environment& environment, const StartState& start,
             std::span<const Push> pushes, float step_s = kStep)
      : skeleton_(skeleton),
        pushes_(pushes),
        environment_(environment),
        world_(skeleton, environment, step_s),
        start_turn_rad_(static_cast<double>(skeleton.start_angle_rad)) {
    PlaceAtStart(start);
  }

  /// Hands the figures to other controllers: their first rules become active, their timers start at zero,
  /// their networks are empty; the motion goes on as it is. The controllers must outlive their use.
  void Follow(const Controllers<W>& controllers) {
    bank_ = std::get_if<Bank<W>>(&controllers);
    network_ = std::get_if<Network<W>>(&controllers);
    timer_steps_ = 0;
    state_.rule = I{};
    if (network_ != nullptr) return network_->Begin(state_.network, state_.response);
    for (int lane = 0; lane < W; ++lane) bank_->Respond(0, lane, state_.response);
  }

  [[nodiscard]] Moment<W> Save() const { return {state_, step_, timer_steps_}; }
  /// @param moment of a simulation with the same figure, step and ground, and the same pushes before it
  /// @param controllers in charge at that moment; null: none
  void Restore(const Moment<W>& moment, const Controllers<W>* controllers) {
    state_ = moment.state;
    step_ = moment.step;
    timer_steps_ = moment.timer_steps;
    bank_ = controllers == nullptr ? nullptr : std::get_if<Bank<W>>(controllers);
    network_ = controllers == nullptr ? nullptr : std::get_if<Network<W>>(controllers);
    SkipPushes();
  }
  /// Every lane begins as one figure was at a moment, at rest or not; what is measured is measured from
  /// there.
  void BeginAt(const Moment<1>& moment) {
    SpreadState<W>(moment.state, state_);
    step_ = moment.step;
    start_turn_rad_ = moment.state.turn_rad[0];
    SkipPushes();
  }

  /// Advances every figure by one step.
  void Step() {
    for (; next_push_ < pushes_.size() && pushes_[next_push_].step <= step_; ++next_push_) {
      Give(pushes_[next_push_]);
    }
    if (environment_.sway_rad != 0.0f) {
      const float time_s = static_cast<float>(step_) * world_.step_s;
      world_.Tilt(environment_.gravity_mps2, GroundAngle(environment_, time_s));
    }
    Fly<W>(skeleton_, world_, state_);
    MeetGround<W>(skeleton_, world_, state_);
    Conclude();
    ++step_;
    ++timer_steps_;
    if (bank_ != nullptr) ChooseRules();
    if (network_ != nullptr) {
      network_->Advance(state_.angle_rad, state_.last_normal, state_.network, state_.response);
    }
  }

  [[nodiscard]] const MotionState<W>& State() const { return state_; }

  [[nodiscard]] Terms TermsOf(int lane) const {
    const MotionState<W>& s = state_;
    Terms terms;
    terms.travel_m = static_cast<float>(s.distance_m[lane]);
    terms.start_height_m = s.start_height_m[lane];
    terms.max_cm_height_m = s.greatest_height_m[lane];
    terms.slip_sum_m = s.slip_m[lane];
    const double turns = (s.turn_rad[lane] - start_turn_rad_) / (2.0 * kPi);
    terms.rotations = static_cast<float>(turns < 0.0 ? -turns : turns);
    terms.broke_physics =
        s.broken[lane] != 0 || !std::isfinite(s.distance_m[lane]) || !std::isfinite(s.height_m[lane]);
    return terms;
  }

  /// Adds this step's positions of one figure to a hash.
  void AddTo(TrajectoryHash& hash, int lane) const {
    const MotionState<W>& s = state_;
    hash.Add(s.distance_m[lane]);
    hash.Add(s.height_m[lane]);
    hash.Add(s.turn_rad[lane]);
    for (std::size_t j = 0; j < static_cast<std::size_t>(skeleton_.joints); ++j)
      hash.Add(s.angle_rad[j][lane]);
  }

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

  /// Past those that were given before the present step.
  void SkipPushes() {
    next_push_ = 0;
    while (next_push_ < pushes_.size() && pushes_[next_push_].step < step_) ++next_push_;
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

  /// The end of the step becomes the state; what was measured in it is added up.
  [[gnu::noinline]] void Conclude() {
    MotionState<W>& s = state_;
    const auto endpoints = static_cast<std::size_t>(skeleton_.endpoints);
    s.velocity_x += s.ground.along * world_.inverse_mass;
    s.velocity_y += s.ground.up * world_.inverse_mass;
    s.angular_momentum += s.ground.moment;
    s.distance_m += L::ToDouble(s.path_x);
    // Turned anew from the start: a direction that is turned on and on would lose what is below its rounding,
    // and a figure at rest would count turns that it does not make.
    s.turn_rad += L::ToDouble(s.spin * world_.step_s);
    SinCosOfTurn<W>(s.turn_rad, s.sine, s.cosine);
    // Whatever still ends below ground is lifted out, by position alone, without velocity.
    F lowest = s.endpoint_height[0];
    for (std::size_t k = 1; k < endpoints; ++k) lowest = L::Min(s.endpoint_height[k], lowest);
    const F lift = L::Max(-lowest, F{});
    s.height_m = s.height_m + s.path_y + lift;
    s.lifting_work_j = lift * world_.weight_n;
    s.greatest_height_m = L::Max(s.greatest_height_m, s.height_m);
    s.slip_m += s.ground.slip_m;
    // Written so that NaN trips the guards too.
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

  [[gnu::noinline]] void ChooseRules() {
    MotionState<W>& s = state_;
    const I chosen = Sense();
    const I changed = chosen != s.rule;
    if (!L::Any(changed)) return;
    s.rule = chosen;
    for (int lane = 0; lane < W; ++lane) {
      if (L::At(changed, lane)) bank_->Respond(L::At(chosen, lane), lane, s.response);
    }
  }

  /// @return the rules that hold what is felt
  I Sense() {
    MotionState<W>& s = state_;
    const SenseSpec& spec = bank_->Senses();
    if (spec.kind == SenseKind::kTimer) {
      const int phase = timer_steps_ % spec.period_steps;
      s.senses[0] = L::Splat(TimerSense(phase, spec.period_steps));
      const I& choice = bank_->ChoiceAt(phase);
      return L::Select(choice < 0, s.rule, choice);
    }
    std::size_t at = 0;
    const float unit_impulse =
        1.0f / (spec.force_weights * world_.mass_kg * kStandardGravity * world_.step_s);
    for (std::size_t j = 0; j < static_cast<std::size_t>(skeleton_.joints); ++j) {
      const Skeleton::Limb& limb = skeleton_.limbs[j + 1];
      s.senses[at++] = (s.angle_rad[j] - limb.min_rad) * limb.inverse_range;
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(skeleton_.endpoints); ++k) {
      s.senses[at++] = L::Min(s.last_normal[k] * unit_impulse, L::Splat(1.0f));
    }
    s.senses[at++] = s.height_m * (1.0f / (spec.height_rods * skeleton_.longest_rod_m));
    s.senses[at++] = (s.velocity_y + spec.velocity_mps) * (1.0f / (2.0f * spec.velocity_mps));
    return bank_->Choose(s.senses, s.rule);
  }

  const Skeleton& skeleton_;
  std::span<const Push> pushes_;
  Environment environment_;
  World world_;
  MotionState<W> state_;
  double start_turn_rad_;          // of the root rod
  const Bank<W>* bank_ = nullptr;  // at most one of the two
  const Network<W>* network_ = nullptr;
  int step_ = 0;
  int timer_steps_ = 0;
  std::size_t next_push_ = 0;
};

}  // namespace gaitsmith
