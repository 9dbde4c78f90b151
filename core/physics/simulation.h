// SPDX-License-Identifier: MIT
// One time step of W figures side by side. Controllers prescribe the joint angles, so at every instant a
// figure is one rigid body of changing shape with three unknown motions. The state holds momentum, not
// velocity: free flight then conserves linear and angular momentum exactly, whatever the joints do
// (docs/physics.md derives every line).
//
//   L = J phi' + H      J(q) = sum m |r|^2 + m l^2 / 12      H(q, q') = sum m (r x u) + (m l^2 / 12) w
//
// J and H are taken at mid-step from the two poses around it: r = (r0 + r1) / 2, u = (r1 - r0) / h. One pose
// per step thus serves both the dynamics (second order in flight) and the contacts, for which it is exact up
// to the square of the angle turned in a step.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/control/bank.h"
#include "core/physics/contact.h"
#include "core/physics/environment.h"
#include "core/physics/joint_response.h"
#include "core/physics/pose.h"
#include "core/physics/task.h"
#include "core/physics/trajectory_hash.h"

namespace gaitsmith {

template <int W>
class Simulation {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;
  using D = typename L::D;

 public:
  /// @param pushes sorted by step; must outlive the simulation, as must the skeleton
  Simulation(const Skeleton& skeleton, const Environment& environment, const StartState& start,
             std::span<const Push> pushes, float step_s = kStep)
      : skeleton_(skeleton), pushes_(pushes), step_s_(step_s), inverse_step_(1.0f / step_s) {
    const SineCosine slope = SinCos(environment.slope_rad);
    fall_x_ = -environment.gravity_mps2 * slope.sine * step_s;
    fall_y_ = -environment.gravity_mps2 * slope.cosine * step_s;
    weight_n_ = skeleton.mass_kg * environment.gravity_mps2 * slope.cosine;
    friction_ = environment.friction;
    inverse_mass_ = 1.0f / skeleton.mass_kg;
    max_ground_work_j_ = kMaxGroundWork * skeleton.mass_kg * kStandardGravity * skeleton.longest_rod_m;
    PlaceAtStart(start);
  }

  /// Hands the figures to other controllers: their first rules become active, their timers start at zero; the
  /// motion goes on as it is. The bank must outlive its use.
  void Follow(const Bank<W>& bank) {
    bank_ = &bank;
    timer_steps_ = 0;
    rule_ = I{};
    bank.Respond(rule_, response_);
  }

  /// Advances every figure by one step.
  void Step() {
    ApplyPushes();
    // Adding zero turns -0 into +0, so that impulses of zero, which only some lane counts add, change no bit.
    velocity_x_ = velocity_x_ + fall_x_ + 0.0f;
    velocity_y_ = velocity_y_ + fall_y_ + 0.0f;

    MoveJoints<W>(skeleton_, response_, step_s_, angle_, rate_, joint_turn_);
    PoseFigure<W>(skeleton_, angle_, next_pose_);
    shape_ = MeasureShape<W>(skeleton_, pose_, next_pose_, joint_turn_, inverse_step_);

    // Free flight: predict the whole step. The path follows the mean velocity, so that free fall is exact.
    spin_ = (angular_momentum_ - shape_.momentum) / shape_.inertia;
    path_x_ = step_s_ * (velocity_x_ - 0.5f * fall_x_);
    const F path_y = step_s_ * (velocity_y_ - 0.5f * fall_y_);
    const D turn = turn_ + L::ToDouble(spin_) * static_cast<double>(step_s_);
    F sine, cosine;
    SinCosOfTurn<W>(turn, sine, cosine);
    PlaceEndpoints(sine, cosine, height_ + path_y);
    std::array<I, kMaxEndpoints> near_ground;
    I any_near{};
    for (std::size_t k = 0; k < Endpoints(); ++k) {
      near_ground[k] = endpoint_height_[k] < kContactMargin;
      any_near |= near_ground[k];
    }
    normal_work_ = friction_work_ = friction_gain_ = lifting_work_ = F{};
    if (L::Any(any_near)) {
      MeetGround(near_ground, path_x_, path_y);
    } else {
      turn_ = turn;
      sine_ = sine;
      cosine_ = cosine;
      distance_ += L::ToDouble(path_x_);
      height_ += path_y;
      loaded_ = {};
      impulses_ = {};
    }
    // Written so that NaN trips the guard too.
    broken_ |= ~(L::Abs(spin_) * step_s_ <= kMaxTurnPerStep);
    std::swap(pose_, next_pose_);
    greatest_height_ = L::Max(greatest_height_, height_);
    ++step_;
    ++timer_steps_;
    ChooseRules();
  }

  [[nodiscard]] Terms TermsOf(int lane) const {
    Terms terms;
    terms.travel_m = static_cast<float>(distance_[lane]);
    terms.start_height_m = start_height_[lane];
    terms.max_cm_height_m = greatest_height_[lane];
    terms.slip_sum_m = slip_sum_[lane];
    const double turns = (turn_[lane] - static_cast<double>(skeleton_.start_angle_rad)) / (2.0 * kPi);
    terms.rotations = static_cast<float>(turns < 0.0 ? -turns : turns);
    terms.broke_physics =
        broken_[lane] != 0 || !std::isfinite(distance_[lane]) || !std::isfinite(height_[lane]);
    return terms;
  }

  /// Adds this step's positions of one figure to a hash.
  void AddTo(TrajectoryHash& hash, int lane) const {
    hash.Add(distance_[lane]);
    hash.Add(height_[lane]);
    hash.Add(turn_[lane]);
    for (std::size_t j = 0; j < Joints(); ++j) hash.Add(angle_[j][lane]);
  }

  // What can be seen of one figure after a step. Endpoint positions are relative to the centre of mass, world
  // axes.
  [[nodiscard]] double DistanceM(int lane) const { return distance_[lane]; }
  [[nodiscard]] float HeightM(int lane) const { return height_[lane]; }
  [[nodiscard]] float VelocityXMps(int lane) const { return velocity_x_[lane]; }
  [[nodiscard]] float VelocityYMps(int lane) const { return velocity_y_[lane]; }
  [[nodiscard]] double TurnRad(int lane) const { return turn_[lane]; }
  [[nodiscard]] float AngularMomentum(int lane) const { return angular_momentum_[lane]; }  // [kg m^2/s]
  [[nodiscard]] float AngleRad(int lane, int joint) const { return angle_[Index(joint)][lane]; }
  [[nodiscard]] float RateRadps(int lane, int joint) const { return rate_[Index(joint)][lane]; }
  [[nodiscard]] int Rule(int lane) const { return rule_[lane]; }
  [[nodiscard]] float SenseValue(int lane, int sense) const { return senses_[Index(sense)][lane]; }
  [[nodiscard]] float NormalForceN(int lane, int endpoint) const {
    return impulses_[Index(endpoint)].normal[lane] * inverse_step_;
  }
  [[nodiscard]] float TangentForceN(int lane, int endpoint) const {
    return impulses_[Index(endpoint)].tangent[lane] * inverse_step_;
  }
  [[nodiscard]] float EndpointX(int lane, int endpoint) const {
    return (cosine_ * pose_.endpoint_x[Index(endpoint)] - sine_ * pose_.endpoint_y[Index(endpoint)])[lane];
  }
  [[nodiscard]] float EndpointY(int lane, int endpoint) const {
    return (sine_ * pose_.endpoint_x[Index(endpoint)] + cosine_ * pose_.endpoint_y[Index(endpoint)])[lane];
  }
  /// Work the ground did in the last step: by normal forces; by friction; of that, by contacts where it had
  /// the wrong sign; by lifting [J].
  struct GroundWork {
    float normal_j, friction_j, friction_gain_j, lifting_j;
  };
  [[nodiscard]] GroundWork WorkOf(int lane) const {
    return {normal_work_[lane], friction_work_[lane], friction_gain_[lane], lifting_work_[lane]};
  }

 private:
  static std::size_t Index(int i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] std::size_t Joints() const { return Index(skeleton_.joints); }
  [[nodiscard]] std::size_t Endpoints() const { return Index(skeleton_.endpoints); }
  [[nodiscard]] std::size_t Rods() const { return Index(skeleton_.rods); }

  void PlaceAtStart(const StartState& start) {
    PoseFigure<W>(skeleton_, angle_, pose_);
    next_pose_ = pose_;
    shape_ = MeasureShape<W>(skeleton_, pose_, next_pose_, joint_turn_, inverse_step_);
    velocity_x_ = L::Splat(start.velocity_x_mps);
    velocity_y_ = L::Splat(start.velocity_y_mps);
    angular_momentum_ = shape_.inertia * start.spin_radps;
    spin_ = L::Splat(start.spin_radps);
    turn_ = L::ToDouble(L::Splat(skeleton_.start_angle_rad));
    SinCosOfTurn<W>(turn_, sine_, cosine_);
    PlaceEndpoints(sine_, cosine_, F{});
    height_ = L::Splat(start.drop_height_m) - Lowest();
    PlaceEndpoints(sine_, cosine_, height_);
    start_height_ = height_;
    greatest_height_ = height_;
  }

  void ApplyPushes() {
    for (; next_push_ < pushes_.size() && pushes_[next_push_].step <= step_; ++next_push_) {
      const Push& push = pushes_[next_push_];
      velocity_x_ += L::Splat(push.impulse_x_ns * inverse_mass_);
      velocity_y_ += L::Splat(push.impulse_y_ns * inverse_mass_);
      if (push.endpoint == kCentreOfMass) continue;
      const std::size_t k = Index(push.endpoint);
      const F arm_x = cosine_ * pose_.endpoint_x[k] - sine_ * pose_.endpoint_y[k];
      const F arm_y = sine_ * pose_.endpoint_x[k] + cosine_ * pose_.endpoint_y[k];
      angular_momentum_ += arm_x * push.impulse_y_ns - arm_y * push.impulse_x_ns;
    }
  }

  /// Heights of all endpoints of the next pose above the ground.
  void PlaceEndpoints(F sine, F cosine, F height) {
    for (std::size_t k = 0; k < Endpoints(); ++k) {
      endpoint_height_[k] = height + (sine * next_pose_.endpoint_x[k] + cosine * next_pose_.endpoint_y[k]);
    }
  }

  [[nodiscard]] F Lowest() const {
    F lowest = endpoint_height_[0];
    for (std::size_t k = 1; k < Endpoints(); ++k) lowest = L::Min(endpoint_height_[k], lowest);
    return lowest;
  }

  /// The step again, with the ground, in the lanes whose endpoints are near it; the others keep the
  /// prediction.
  void MeetGround(std::array<I, kMaxEndpoints> near_ground, F flight_x, F flight_y) {
    const D start_turn = turn_;
    const F start_sine = sine_, start_cosine = cosine_, start_height = height_;
    const RigidMotion<W> free{velocity_x_, velocity_y_, spin_};
    const F start_momentum = angular_momentum_;
    // The first round starts from the impulses of the step before: two feet that are driven apart stay on the
    // edge of their friction cones, where from zero they would take many sweeps to arrive again. The second
    // starts from the first.
    // Only where an endpoint still is near: what other lanes do must not decide which old impulses are
    // remembered.
    std::array<Impulse<W>, kMaxEndpoints> known{};
    for (std::size_t k = 0; k < Endpoints(); ++k) {
      known[k].normal = L::Select(near_ground[k], impulses_[k].normal, F{});
      known[k].tangent = L::Select(near_ground[k], impulses_[k].tangent, F{});
    }
    impulses_ = {};
    std::array<Contact<W>, kMaxEndpoints> contacts;
    std::span<Contact<W>> met;
    for (int round = 0; round < kContactRounds; ++round) {
      met = std::span(contacts.data(),
                      GatherContacts(near_ground, known, start_sine, start_cosine, start_height, contacts));
      RigidMotion<W> motion = free;
      SolveContacts<W>(met, inverse_mass_, 1.0f / shape_.inertia, friction_, motion);
      F moment{};
      I touched{};
      for (const Contact<W>& c : met) {
        moment += c.arm_x * c.normal - c.arm_y * c.tangent;
        touched |= c.normal > 0.0f;
        known[c.endpoint] = {c.normal, c.tangent};
      }
      // Impulses change L directly; the new spin follows from it, so that no rounding leaks from one into the
      // other.
      velocity_x_ = L::Select(touched, motion.velocity_x, free.velocity_x);
      velocity_y_ = L::Select(touched, motion.velocity_y, free.velocity_y);
      angular_momentum_ = L::Select(touched, start_momentum + moment, start_momentum);
      spin_ = L::Select(touched, (angular_momentum_ - shape_.momentum) / shape_.inertia, free.spin);
      path_x_ = L::Select(touched, step_s_ * velocity_x_, flight_x);
      height_ = start_height + L::Select(touched, step_s_ * velocity_y_, flight_y);
      turn_ = start_turn + L::ToDouble(spin_) * static_cast<double>(step_s_);
      SinCosOfTurn<W>(turn_, sine_, cosine_);
      PlaceEndpoints(sine_, cosine_, height_);
      // A landing may throw further endpoints against the ground: they take part in the next round.
      for (std::size_t k = 0; k < Endpoints(); ++k)
        near_ground[k] |= touched & (endpoint_height_[k] < kContactMargin);
    }
    distance_ += L::ToDouble(path_x_);
    LiftOut();
    Account(met);
  }

  /// Lists the endpoints near the ground in any lane, their arms taken at mid-step of the present guess of
  /// the spin.
  std::size_t GatherContacts(const std::array<I, kMaxEndpoints>& near_ground,
                             const std::array<Impulse<W>, kMaxEndpoints>& known, F start_sine, F start_cosine,
                             F start_height, std::array<Contact<W>, kMaxEndpoints>& contacts) const {
    // Half of the turn, by series: at most 0.25 rad, or the motion is void anyway.
    const F half = 0.5f * step_s_ * spin_;
    const F half2 = half * half;
    const F half_sine = half * (1.0f - half2 * (1.0f / 6.0f) * (1.0f - half2 * (1.0f / 20.0f)));
    const F half_cosine = 1.0f - 0.5f * half2 * (1.0f - half2 * (1.0f / 12.0f));
    const F sine = start_sine * half_cosine + start_cosine * half_sine;
    const F cosine = start_cosine * half_cosine - start_sine * half_sine;
    std::size_t count = 0;
    for (std::size_t k = 0; k < Endpoints(); ++k) {
      if (!L::Any(near_ground[k])) continue;
      Contact<W>& c = contacts[count++];
      const F r_x = 0.5f * (pose_.endpoint_x[k] + next_pose_.endpoint_x[k]);
      const F r_y = 0.5f * (pose_.endpoint_y[k] + next_pose_.endpoint_y[k]);
      const F u_x = (next_pose_.endpoint_x[k] - pose_.endpoint_x[k]) * inverse_step_;
      const F u_y = (next_pose_.endpoint_y[k] - pose_.endpoint_y[k]) * inverse_step_;
      c.arm_x = cosine * r_x - sine * r_y;
      c.arm_y = sine * r_x + cosine * r_y;
      c.drift_x = cosine * u_x - sine * u_y;
      c.drift_y = sine * u_x + cosine * u_y;
      const F gap = start_height + (start_sine * pose_.endpoint_x[k] + start_cosine * pose_.endpoint_y[k]);
      c.reach = L::Max(gap, F{}) * inverse_step_;
      c.near_ground = near_ground[k];
      c.normal = known[k].normal;
      c.tangent = known[k].tangent;
      c.endpoint = k;
    }
    return count;
  }

  /// Whatever still ends below ground is lifted out, by position alone, without velocity.
  void LiftOut() {
    const F lift = L::Max(-Lowest(), F{});
    height_ += lift;
    broken_ |= lift > kMaxPenetration;
    lifting_work_ = lift * weight_n_;
  }

  void Account(std::span<const Contact<W>> met) {
    std::array<I, kMaxEndpoints> loaded{};
    for (const Contact<W>& c : met) {
      loaded[c.endpoint] = c.normal > 0.0f;
      const I slipping = loaded[c.endpoint] & loaded_[c.endpoint];
      slip_sum_ += L::Select(slipping, L::Abs(c.slide) * step_s_, F{});
      impulses_[c.endpoint] = {c.normal, c.tangent};
      normal_work_ += c.normal * c.approach;
      const F work = c.tangent * c.slide;
      friction_work_ += work;
      friction_gain_ += L::Max(work, F{});
    }
    loaded_ = loaded;
    broken_ |= ~(normal_work_ + friction_work_ + lifting_work_ <= max_ground_work_j_);
  }

  void ChooseRules() {
    if (bank_ == nullptr) return;
    Sense();
    const I chosen = bank_->Choose(senses_, rule_);
    if (!L::Any(chosen != rule_)) return;
    rule_ = chosen;
    bank_->Respond(rule_, response_);
  }

  void Sense() {
    const SenseSpec& spec = bank_->Senses();
    if (spec.kind == SenseKind::kTimer) {
      const int phase = timer_steps_ % spec.period_steps;
      senses_[0] = L::Splat(static_cast<float>(phase) / static_cast<float>(spec.period_steps));
      return;
    }
    std::size_t at = 0;
    for (std::size_t j = 0; j < Joints(); ++j) {
      const Skeleton::Limb& limb = skeleton_.limbs[j + 1];
      // A locked joint (no range) always feels its middle.
      const float range = limb.max_rad - limb.min_rad;
      senses_[at++] = range > 0.0f ? (angle_[j] - limb.min_rad) * (1.0f / range) : L::Splat(0.5f);
    }
    const float per_impulse = inverse_step_ / (spec.force_weights * skeleton_.mass_kg * kStandardGravity);
    for (std::size_t k = 0; k < Endpoints(); ++k) {
      senses_[at++] = L::Min(impulses_[k].normal * per_impulse, L::Splat(1.0f));
    }
    senses_[at++] = height_ * (1.0f / (spec.height_rods * skeleton_.longest_rod_m));
    senses_[at++] = (velocity_y_ + spec.velocity_mps) * (1.0f / (2.0f * spec.velocity_mps));
  }

  const Skeleton& skeleton_;
  std::span<const Push> pushes_;
  const Bank<W>* bank_ = nullptr;
  float step_s_, inverse_step_;
  float fall_x_, fall_y_;  // change of velocity by gravity in a step [m/s]
  float weight_n_;         // normal to the ground
  float friction_, inverse_mass_, max_ground_work_j_;

  // State of motion.
  D distance_{};  // of the centre of mass along the ground [m]
  F height_{};    // of the centre of mass above it [m]
  F velocity_x_{}, velocity_y_{};
  D turn_{};              // of the root rod [rad], whole turns included
  F sine_{}, cosine_{};   // of turn_
  F angular_momentum_{};  // about the centre of mass [kg m^2/s]
  F spin_{};              // of the root rod [rad/s]
  std::array<F, kMaxJoints> angle_{}, rate_{};
  std::array<I, kMaxEndpoints> loaded_{};
  std::array<Impulse<W>, kMaxEndpoints> impulses_{};  // of the ground in the last step
  I rule_{};
  int step_ = 0;
  int timer_steps_ = 0;
  std::size_t next_push_ = 0;

  // Derived within a step.
  Response<W> response_{};
  std::array<F, kMaxJoints> joint_turn_{};
  Pose<W> pose_{}, next_pose_{};
  Shape<W> shape_{};
  F path_x_{};  // of the centre of mass in this step [m]
  std::array<F, kMaxEndpoints> endpoint_height_{};
  F normal_work_{}, friction_work_{}, friction_gain_{}, lifting_work_{};
  SenseVector<W> senses_{};

  // Measured over the motion.
  F start_height_{}, greatest_height_{}, slip_sum_{};
  I broken_{};
};

}  // namespace gaitsmith
