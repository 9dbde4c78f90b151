// SPDX-License-Identifier: MIT
// One step of W figures with moving limbs: joints that follow their rules as far as their strength reaches,
// joint limits that push back, and the ground. All three depend on each other, so the step is solved in
// rounds until nothing changes.
//
// The limbs move by the implicit midpoint rule: with the momenta p at the beginning, the mass matrix M and
// the bias b at mid-step, M speed = p + h b / 2 + impulses, and p + h b + impulses at the end. The impulses
// of joints and ground act at the beginning of the step. Only the ground changes the angular momentum of the
// whole figure, so flight keeps it exactly.
#pragma once

#include "core/numeric/scalar_math.h"
#include "core/physics/joint_response.h"
#include "core/physics/limb_arms.h"
#include "core/physics/limb_end.h"
#include "core/physics/limb_state.h"

namespace gaitsmith {

/// Rounds of one step, at most. From kSingleChoices on only one joint at a time changes what it does, the
/// last that must: then the choice comes to an end for joints and smooth ground [Murty 1974].
inline constexpr int kLimbRounds = 40;
inline constexpr int kSingleChoices = 4;
/// With friction there may be no end: rarely, where weak figures fall hard, a joint can neither be at its
/// limit nor away from it (Painleve's paradox). After this many rounds the ground is smooth until the step
/// ends.
inline constexpr int kRoughRounds = 10;
/// Mid-step directions are measured again if a rod turns further than this from where they were taken [rad].
inline constexpr float kMidTurn = 1e-3f;
/// A joint is stopped when it would end further than this beyond its limit [rad].
inline constexpr float kStopMargin = 1e-4f;

/// @tparam Ground what the figures stand on during a step: LevelGround or DrawnGround
template <int W, class Ground>
class LimbStep {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;

 public:
  /// @param state  gravity is already in its velocity
  /// @param ground of this state
  LimbStep(const Mechanism& body, const World& world, const ActuatorTargets<W>& targets, LimbState<W>& state,
           Ground& ground)
      : body_(body), world_(world), s_(state), ground_(ground), rods_(static_cast<std::size_t>(body.rods)) {
    // What the joints' rules ask for: model 1's response, from where the joints really are.
    asked_angle_ = s_.angle_rad;
    asked_rate_ = s_.rate_radps;
    MoveJoints<W>(body, targets, world.step_s, asked_angle_, asked_rate_, asked_turn_);
    Foresee();
    PlaceEnd(speed_, end_);
    MeasureMiddle(~I{});
    Run();
  }

  /// Makes the end of the step the state.
  void Conclude() {
    const float h = world_.step_s;
    const LimbNumbers<W> turning = TurningOf<W>(body_, speed_);
    MeasureBias<W>(body_, cosine_, sine_, turning, inertia_);
    F fastest{};
    for (std::size_t a = 0; a < rods_; ++a) fastest = L::Max(fastest, L::Abs(turning[a]));
    const F inverse_inertia = 1.0f / inertia_.mass[0][0];
    for (std::size_t i = 1; i < rods_; ++i) {
      s_.root_answer[i] = inertia_.mass[i][0] * inverse_inertia;
      // With the bias at the speeds that were found, not half of that which was foreseen: otherwise a step of
      // a single round would be accurate to first order only.
      s_.momentum[i] += h * inertia_.bias[i] + (given_[i] + impulse_[i]);
      s_.joint_impulse[i] = impulse_[i];
      s_.joint_turn[i - 1] = h * speed_[i];
      s_.angle_rad[i - 1] += s_.joint_turn[i - 1];
      const I follows = (s_.torque_side[i] == 0.0f) & (s_.stop_side[i] == 0.0f);
      s_.rate_radps[i - 1] =
          L::Select(follows, asked_rate_[i - 1], L::Select(s_.stop_side[i] == 0.0f, speed_[i], F{}));
    }
    s_.speed = speed_;
    ground_.Conclude(end_);
    s_.angular_momentum += given_[0];
    s_.distance_m += L::ToDouble(end_.path_x);
    s_.turn_rad += L::ToDouble(h * speed_[0]);
    PlaceLimbs<W>(body_, s_);
    s_.height_m += end_.path_y;
    const F lift = ground_.Lift();
    s_.greatest_height_m = L::Max(s_.greatest_height_m, s_.height_m);
    const F work = s_.normal_work_j + s_.friction_work_j + s_.lifting_work_j;
    s_.broken |= ~(ground_.Lawful() & (lift <= kMaxPenetration) & (work <= world_.max_ground_work_j) &
                   (fastest * h <= kMaxTurnPerStep));
  }

 private:
  /// Guesses the speeds of this step: joints that follow their rules do what these ask for, and the root
  /// answers as it did in the last step.
  void Foresee() {
    speed_ = s_.speed;
    for (std::size_t i = 1; i < rods_; ++i) {
      const I follows = (s_.torque_side[i] == 0.0f) & (s_.stop_side[i] == 0.0f);
      speed_[i] = L::Select(follows, asked_turn_[i - 1] * world_.inverse_step, speed_[i]);
      speed_[0] -= s_.root_answer[i] * (speed_[i] - s_.speed[i]);
    }
  }

  /// The middle of the step as it is known so far, in the given lanes.
  void MeasureMiddle(const I& lanes) {
    const LimbNumbers<W> turning = TurningOf<W>(body_, speed_);
    for (std::size_t a = 0; a < rods_; ++a) {
      F sine = s_.sine[a], cosine = s_.cosine[a];
      Turn<W>(0.5f * world_.step_s * turning[a], sine, cosine);
      sine_[a] = L::Select(lanes, sine, sine_[a]);
      cosine_[a] = L::Select(lanes, cosine, cosine_[a]);
      turning_[a] = L::Select(lanes, turning[a], turning_[a]);
    }
    MeasureMass<W>(body_, cosine_, sine_, inertia_);
    MeasureBias<W>(body_, cosine_, sine_, turning_, inertia_);
    base_[0] = s_.angular_momentum;
    for (std::size_t i = 1; i < rods_; ++i)
      base_[i] = s_.momentum[i] + 0.5f * world_.step_s * inertia_.bias[i];
  }

  void Run() {
    I open = ~I{};
    for (int round = 0; round < kLimbRounds && L::Any(open); ++round) {
      const LimbArms<W> arms(body_, cosine_, sine_);
      LimbNumbers<W> firmness, speed;
      Choose(firmness, speed);
      const LimbFactor<W> factor(rods_, inertia_, firmness);
      // The impulses known so far act on the arms as they are now.
      LimbNumbers<W> given{};
      ground_.Look(end_, arms, round);
      ground_.AddMomenta(given);
      for (std::size_t i = 0; i < rods_; ++i) speed[i] += base_[i] + given[i];
      factor.SolveInward(speed);
      LimbNumbers<W> inward = speed;
      factor.SolveOutward(speed);
      if (ground_.Touches()) {
        // From where the last round ended, in a straight line: the way of a limb that is thrown about by
        // impulses of an earlier round would mean nothing.
        LimbNumbers<W> since;
        for (std::size_t i = 0; i < rods_; ++i) since[i] = speed[i] - speed_[i];
        ground_.Solve(factor, end_, since, round >= kRoughRounds, inward, given);
        factor.SolveOutward(inward);
        speed = inward;
      }
      open = Accept(open, round, speed, given);
      if (L::Any(open)) MeasureMiddle(open);
    }
  }

  /// The diagonal and the right side of the joints, by what each of them does.
  void Choose(LimbNumbers<W>& firmness, LimbNumbers<W>& right) const {
    firmness[0] = right[0] = F{};
    for (std::size_t i = 1; i < rods_; ++i) {
      const I stopped = s_.stop_side[i] != 0.0f, strained = s_.torque_side[i] != 0.0f;
      firmness[i] = L::Select(stopped, L::Splat(body_.stop_firmness[i]),
                              L::Select(strained, F{}, L::Splat(body_.firmness[i])));
      const F torque = s_.torque_side[i] * (body_.torque_nm[i] * world_.step_s);
      right[i] = firmness[i] * Wanted(i) + L::Select(strained & ~stopped, torque, F{});
    }
  }

  /// The speed that a joint's rule, or its stop, asks for [rad/s].
  [[nodiscard]] F Wanted(std::size_t i) const {
    const F edge =
        L::Select(s_.stop_side[i] > 0.0f, L::Splat(body_.limbs[i].max_rad), L::Splat(body_.limbs[i].min_rad));
    return L::Select(s_.stop_side[i] != 0.0f, edge - s_.angle_rad[i - 1], asked_turn_[i - 1]) *
           world_.inverse_step;
  }

  /// Takes over what a round found in the open lanes, and chooses again.
  /// @return the lanes in which something has changed
  I Accept(const I& open, int round, const LimbNumbers<W>& speed, const LimbNumbers<W>& given) {
    const float h = world_.step_s;
    const LimbNumbers<W> momenta = inertia_.Momenta(rods_, speed);
    const bool single = round >= kSingleChoices, last = round + 1 == kLimbRounds;
    I changed{};
    for (std::size_t i = rods_; i-- > 1;) {
      const float most = body_.torque_nm[i] * h;
      const F side = s_.torque_side[i], stop = s_.stop_side[i];
      // At its greatest torque a joint's impulse is known, and the rounding of the speeds must not add up.
      const F impulse =
          L::Select((side != 0.0f) & (stop == 0.0f), side * most, momenta[i] - base_[i] - given[i]);
      // From one greatest torque to the other a joint passes through what its rule asks for.
      const F asks = body_.firmness[i] * (asked_turn_[i - 1] * world_.inverse_step - speed[i]);
      const F strained =
          L::Select(impulse > most, L::Splat(1.0f), L::Select(impulse < -most, L::Splat(-1.0f), F{}));
      // A limp joint has no rule to pass through.
      const I eases = most > 0.0f ? side * asks < most : I{};
      const F next_side =
          L::Select(stop != 0.0f, side, L::Select(side == 0.0f, strained, L::Select(eases, F{}, side)));
      const F end = s_.angle_rad[i - 1] + h * speed[i];
      const F beyond = L::Select(end > body_.limbs[i].max_rad + kStopMargin, L::Splat(1.0f),
                                 L::Select(end < body_.limbs[i].min_rad - kStopMargin, L::Splat(-1.0f), F{}));
      const F next_stop = L::Select(stop == 0.0f, beyond, L::Select(stop * impulse > 0.0f, F{}, stop));
      const I wants = (next_side != side) | (next_stop != stop);
      const I may = last ? I{} : single ? open & ~changed : open;
      changed |= wants;
      // Should the rounds run out, a joint's strength still is its limit, and a stop does not pull.
      F kept = impulse;
      if (last) {
        kept = L::Select(stop == 0.0f, L::Max(L::Min(impulse, L::Splat(most)), L::Splat(-most)),
                         L::Select(stop * impulse > 0.0f, F{}, impulse));
      }
      impulse_[i] = L::Select(open, kept, impulse_[i]);
      s_.torque_side[i] = L::Select(may, next_side, side);
      s_.stop_side[i] = L::Select(may, next_stop, stop);
    }
    const LimbNumbers<W> turning = TurningOf<W>(body_, speed);
    for (std::size_t a = 0; a < rods_; ++a) {
      changed |= L::Abs(turning[a] - turning_[a]) * h > 2.0f * kMidTurn;
      speed_[a] = L::Select(open, speed[a], speed_[a]);
      given_[a] = L::Select(open, given[a], given_[a]);
    }
    LimbEnd<W> end;
    PlaceEnd(speed, end);
    changed |= ground_.Accept(open, end);
    for (std::size_t k = 0; k <= rods_; ++k) {
      end_.move_x[k] = L::Select(open, end.move_x[k], end_.move_x[k]);
      end_.move_y[k] = L::Select(open, end.move_y[k], end_.move_y[k]);
    }
    end_.path_x = L::Select(open, end.path_x, end_.path_x);
    end_.path_y = L::Select(open, end.path_y, end_.path_y);
    return open & changed;
  }

  /// Where the step ends with these speeds, and with the ground's impulses as the present round found them.
  void PlaceEnd(const LimbNumbers<W>& speed, LimbEnd<W>& end) const {
    const LimbNumbers<W> turning = TurningOf<W>(body_, speed);
    LimbNumbers<W> cosine, sine;
    for (std::size_t a = 0; a < rods_; ++a)
      TurnedBy<W>(world_.step_s * turning[a], s_.sine[a], s_.cosine[a], sine[a], cosine[a]);
    const LimbArms<W> moves(body_, cosine, sine);
    end.move_x = moves.x;
    end.move_y = moves.y;
    SetPath(world_, s_, ground_.Sum(), end);
  }

  const Mechanism& body_;
  const World& world_;
  LimbState<W>& s_;
  Ground& ground_;
  std::size_t rods_;
  std::array<F, kMaxJoints> asked_angle_, asked_rate_, asked_turn_;
  // The middle of the step.
  LimbNumbers<W> cosine_{}, sine_{}, turning_{};
  LimbInertia<W> inertia_;
  LimbNumbers<W> base_;  // momenta at mid-step without impulses
  // As found so far.
  LimbNumbers<W> speed_;
  LimbNumbers<W> impulse_{};  // of each joint [N m s]
  LimbNumbers<W> given_{};    // momenta by the ground
  LimbEnd<W> end_;
};

}  // namespace gaitsmith
