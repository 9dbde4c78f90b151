// SPDX-License-Identifier: MIT
// Measures our own style terms of a plant. It only reads the plant after every step. So no motion depends on
// what is measured, and a search that gives these terms no weight does not pay for them. docs/style.md
// defines them.
#pragma once

#include <array>

#include "core/rollout/plant.h"

namespace gaitsmith {

template <Plant P>
class StyleMeter {
  using L = Lane<P::kLanes>;
  using F = typename L::F;
  using D = typename L::D;

 public:
  /// The sums so far.
  struct Sums {
    int steps = 0;
    std::array<F, kMaxActuators> rate_radps{};  // of each joint before the step
    D turned_rad{}, rate_change_radps{}, upright{}, head_m{};
  };
  [[nodiscard]] const Sums& Save() const { return sums_; }
  void Restore(const Sums& sums) { sums_ = sums; }

  /// @param plant that has not stepped yet; must outlive the meter
  /// @param ports of the plant
  /// @param wanted terms to measure; the others stay 0
  StyleMeter(const P& plant, const PortCount& ports, const FurtherTerms& wanted, float step_s)
      : plant_(plant),
        actuators_(static_cast<std::size_t>(ports.actuators)),
        wanted_(wanted),
        step_s_(step_s) {
    const Readings<P::kLanes> now = plant.Read();
    for (std::size_t j = 0; j < actuators_; ++j) sums_.rate_radps[j] = now.rate[j];
  }

  /// Call after every step. The sum over the joints of one step is in single precision, the sum over the
  /// motion in double, so that a motion of two minutes loses nothing.
  [[gnu::noinline]] void Add() {
    ++sums_.steps;
    const Readings<P::kLanes> now = plant_.Read();
    if (Wants(StyleTerm::kEffort)) {
      F turned{};
      for (std::size_t j = 0; j < actuators_; ++j) turned += L::Abs(now.change[j]);
      sums_.turned_rad += L::ToDouble(turned);
    }
    if (Wants(StyleTerm::kSmoothness)) {
      F changed{};
      for (std::size_t j = 0; j < actuators_; ++j) {
        changed += L::Abs(now.rate[j] - sums_.rate_radps[j]);
        sums_.rate_radps[j] = now.rate[j];
      }
      sums_.rate_change_radps += L::ToDouble(changed);
    }
    if (Wants(StyleTerm::kUpright)) sums_.upright += L::ToDouble(plant_.Upright());
    if (Wants(StyleTerm::kHeadHeight)) sums_.head_m += L::ToDouble(plant_.HeadHeight());
  }

  /// Writes one lane's terms so far. Before the first step a mean is the value at the start.
  void Put(int lane, Terms& terms) const {
    const double steps = sums_.steps;
    const bool none = sums_.steps == 0;
    if (Wants(StyleTerm::kEffort)) terms.effort_rad = static_cast<float>(sums_.turned_rad[lane]);
    if (Wants(StyleTerm::kUpright)) {
      terms.upright = none ? L::At(plant_.Upright(), lane) : static_cast<float>(sums_.upright[lane] / steps);
    }
    if (Wants(StyleTerm::kSmoothness) && !none && actuators_ > 0) {
      const double seconds = steps * static_cast<double>(actuators_) * static_cast<double>(step_s_);
      terms.smoothness_radps2 =
          static_cast<float>(0.0 - sums_.rate_change_radps[lane] / seconds);  // never -0
    }
    if (Wants(StyleTerm::kHeadHeight)) {
      terms.head_height_m =
          none ? L::At(plant_.HeadHeight(), lane) : static_cast<float>(sums_.head_m[lane] / steps);
    }
  }

 private:
  [[nodiscard]] bool Wants(StyleTerm term) const {
    return wanted_[static_cast<std::size_t>(term) - static_cast<std::size_t>(kPaperTerms)];
  }

  const P& plant_;
  std::size_t actuators_;
  FurtherTerms wanted_;
  float step_s_;
  Sums sums_;
};

}  // namespace gaitsmith
