// SPDX-License-Identifier: MIT
// What makes a motion of model 2 void beyond the limits that a step checks itself (see limb_step.h), and what
// becomes of its numbers then.
#pragma once

#include <array>
#include <cmath>

#include "core/physics/limb_inertia.h"
#include "core/physics/limb_state.h"

namespace gaitsmith {

/// A motion is void when a joint passes its limit by more than this [rad]. Stops give way, a thousandth as
/// much as a limp joint would; where masses differ a millionfold, limbs turn through them.
inline constexpr float kMaxStopSlack = 0.2f;

/// A motion is void when its limbs turn too slowly for its angular momentum, by this share and by this rate
/// [rad/s]. After a blow that turns a limb by half a turn in a step, directions at mid-step, which are a
/// series in the turn, grow without bounds, and with them the inertia: the figure would seem to stand still.
inline constexpr float kMaxLostTurning = 0.01f;
inline constexpr float kMaxLostRate = 0.1f;

template <int W>
class LimbGuard {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;

 public:
  /// @param body must outlive the guard
  explicit LimbGuard(const Mechanism& body) : body_(body) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(body.rods); ++k) {
      for (std::size_t j = 0; j < static_cast<std::size_t>(body.rods); ++j)
        most_[k] += std::abs(body.coupling[j][k]);
    }
  }

  /// Where figures are. A void motion whose numbers are no longer finite goes on from there.
  struct Place {
    typename L::D place_m, distance_m, turn_rad;
    F height_m, greatest_height_m, slip_m;
    std::array<F, kMaxJoints> angle_rad;
  };
  [[nodiscard]] Place PlaceOf(const LimbState<W>& s) const {
    Place place;
    place.place_m = s.place_m;
    place.distance_m = s.distance_m;
    place.turn_rad = s.turn_rad;
    place.height_m = s.height_m;
    place.greatest_height_m = s.greatest_height_m;
    place.slip_m = s.slip_m;
    for (std::size_t j = 0; j < static_cast<std::size_t>(body_.joints); ++j)
      place.angle_rad[j] = s.angle_rad[j];
    return place;
  }

  /// Judges a step. @return whether a lane has a number that is not finite
  bool Judge(LimbState<W>& s) const {
    F slack{};
    for (std::size_t i = 1; i < static_cast<std::size_t>(body_.rods); ++i) {
      const F angle = s.angle_rad[i - 1];
      slack = L::Max(L::Max(angle - body_.limbs[i].max_rad, body_.limbs[i].min_rad - angle), slack);
    }
    const LimbNumbers<W> turning = TurningOf<W>(body_, s.speed);
    F most{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(body_.rods); ++k)
      most += most_[k] * ((1.0f + kMaxLostTurning) * L::Abs(turning[k]) + kMaxLostRate);
    s.broken |= ~((slack <= kMaxStopSlack) & (L::Abs(s.angular_momentum) <= most));
    if (!L::Any(s.broken)) return false;
    for (int lane = 0; lane < W; ++lane) {
      if (!IsFinite(s, lane)) return true;
    }
    return false;
  }

  /// Lets the lanes that are not finite rest where they were. The endpoints are to be placed anew.
  void Rest(const Place& place, LimbState<W>& s) const {
    for (int lane = 0; lane < W; ++lane) {
      if (IsFinite(s, lane)) continue;
      const auto zero = [lane](auto&... numbers) { (L::Put(numbers, lane, 0.0f), ...); };
      const auto zeros = [lane](auto&... lists) {
        const auto one = [lane](auto& list) {
          for (F& number : list) L::Put(number, lane, 0.0f);
        };
        (one(lists), ...);
      };
      zero(s.velocity_x, s.velocity_y, s.angular_momentum, s.normal_work_j, s.friction_work_j,
           s.friction_gain_j, s.lifting_work_j);
      zeros(s.rate_radps, s.momentum, s.speed, s.root_answer, s.torque_side, s.stop_side, s.last_force.normal,
            s.last_force.tangent, s.joint_turn, s.joint_impulse);
      s.place_m[lane] = place.place_m[lane];
      s.distance_m[lane] = place.distance_m[lane];
      s.turn_rad[lane] = place.turn_rad[lane];
      L::Put(s.height_m, lane, L::At(place.height_m, lane));
      L::Put(s.greatest_height_m, lane, L::At(place.greatest_height_m, lane));
      L::Put(s.slip_m, lane, L::At(place.slip_m, lane));
      for (std::size_t j = 0; j < static_cast<std::size_t>(body_.joints); ++j)
        L::Put(s.angle_rad[j], lane, L::At(place.angle_rad[j], lane));
    }
  }

 private:
  bool IsFinite(const LimbState<W>& s, int lane) const {
    // A sum is finite only if all of its numbers are.
    double sum = s.distance_m[lane] + s.turn_rad[lane];
    const auto add = [&](const F& number) { sum += static_cast<double>(L::At(number, lane)); };
    for (const F* number :
         {&s.height_m, &s.velocity_x, &s.velocity_y, &s.angular_momentum, &s.slip_m, &s.greatest_height_m,
          &s.normal_work_j, &s.friction_work_j, &s.friction_gain_j, &s.lifting_work_j})
      add(*number);
    for (std::size_t i = 0; i <= static_cast<std::size_t>(body_.rods); ++i) {
      add(s.last_force.normal[i]);
      add(s.last_force.tangent[i]);
      add(s.endpoint_x[i]);
      add(s.endpoint_y[i]);
      if (i == static_cast<std::size_t>(body_.rods)) break;
      add(s.momentum[i]);
      add(s.speed[i]);
      add(s.root_answer[i]);
      add(s.joint_impulse[i]);
      if (i == static_cast<std::size_t>(body_.joints)) continue;
      add(s.angle_rad[i]);
      add(s.rate_radps[i]);
      add(s.joint_turn[i]);
    }
    return std::isfinite(sum);
  }

  const Mechanism& body_;
  std::array<float, kMaxRods> most_{};  // angular momentum by the turning of each rod, at most [kg m^2]
};

}  // namespace gaitsmith
