// SPDX-License-Identifier: MIT
// Measures the further style terms of W figures from outside: it reads the state after every step and changes
// nothing. So no motion depends on what is measured of it, and whoever asks for none of these terms pays for
// none. docs/style.md defines them.
#pragma once

#include <array>

#include "core/physics/motion_state.h"
#include "core/rollout/task.h"

namespace gaitsmith {

template <int W>
class StyleMeter {
  using L = Lane<W>;
  using F = typename L::F;
  using D = typename L::D;

 public:
  /// What has been summed up so far.
  struct Sums {
    int steps = 0;
    std::array<F, kMaxJoints> rate_radps{};  // of each joint before the step
    D turned_rad{}, rate_change_radps{}, upright{}, head_m{};
  };
  [[nodiscard]] const Sums& Save() const { return sums_; }
  void Restore(const Sums& sums) { sums_ = sums; }

  /// @param skeleton, state of a simulation that has not stepped yet; both must outlive the meter
  /// @param wanted          terms to measure; the others stay 0
  StyleMeter(const Skeleton& skeleton, const MotionState<W>& state, const FurtherTerms& wanted, float step_s)
      : skeleton_(skeleton), state_(state), wanted_(wanted), step_s_(step_s) {
    sums_.rate_radps = state.rate_radps;
  }

  /// Call it after every step. A step's sum over the joints is single, the motion's sum double precision, so
  /// that two minutes lose nothing.
  [[gnu::noinline]] void Add() {
    ++sums_.steps;
    if (Wants(StyleTerm::kEffort)) {
      F turned{};
      for (std::size_t j = 0; j < Joints(); ++j) turned += L::Abs(state_.joint_turn[j]);
      sums_.turned_rad += L::ToDouble(turned);
    }
    if (Wants(StyleTerm::kSmoothness)) {
      F changed{};
      for (std::size_t j = 0; j < Joints(); ++j) {
        changed += L::Abs(state_.rate_radps[j] - sums_.rate_radps[j]);
        sums_.rate_radps[j] = state_.rate_radps[j];
      }
      sums_.rate_change_radps += L::ToDouble(changed);
    }
    if (Wants(StyleTerm::kUpright)) sums_.upright += L::ToDouble(Upright());
    if (Wants(StyleTerm::kHeadHeight)) sums_.head_m += L::ToDouble(HeadHeight());
  }

  /// Puts what one figure has done so far into its terms. Before the first step a mean is the start's value.
  void Put(int lane, Terms& terms) const {
    const double steps = sums_.steps;
    const bool none = sums_.steps == 0;
    if (Wants(StyleTerm::kEffort)) terms.effort_rad = static_cast<float>(sums_.turned_rad[lane]);
    if (Wants(StyleTerm::kUpright)) {
      terms.upright = none ? L::At(Upright(), lane) : static_cast<float>(sums_.upright[lane] / steps);
    }
    if (Wants(StyleTerm::kSmoothness) && !none && skeleton_.joints > 0) {
      const double seconds = steps * skeleton_.joints * static_cast<double>(step_s_);
      terms.smoothness_radps2 =
          static_cast<float>(0.0 - sums_.rate_change_radps[lane] / seconds);  // never -0
    }
    if (Wants(StyleTerm::kHeadHeight)) {
      terms.head_height_m = none ? L::At(HeadHeight(), lane) : static_cast<float>(sums_.head_m[lane] / steps);
    }
  }

 private:
  [[nodiscard]] std::size_t Joints() const { return static_cast<std::size_t>(skeleton_.joints); }
  [[nodiscard]] bool Wants(StyleTerm term) const {
    return wanted_[static_cast<std::size_t>(term) - static_cast<std::size_t>(kPaperTerms)];
  }
  /// Not from the state's sine and cosine, whose squares add up to 1 but for rounding: a figure that has not
  /// turned is upright to the bit.
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

  const Skeleton& skeleton_;
  const MotionState<W>& state_;
  FurtherTerms wanted_;
  float step_s_;
  Sums sums_;
};

}  // namespace gaitsmith
