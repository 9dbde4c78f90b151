// SPDX-License-Identifier: MIT
// Measures our own style terms of a plant. It only reads the plant after every step. So no motion depends on
// what is measured, and a search that gives these terms no weight does not pay for them. docs/style.md
// defines them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "core/rollout/plant.h"
#include "core/world/environment.h"

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
    // Of the muscles.
    std::array<F, kMaxActuators> speed_radps{};  // mean of each joint in the last step
    typename P::Muscles::Memory memory{};
    D work_j{};
    F peak_j{};  // most work of a step
  };
  [[nodiscard]] const Sums& Save() const { return sums_; }
  void Restore(const Sums& sums) { sums_ = sums; }

  /// @param plant that has not stepped yet; must outlive the meter
  /// @param body, ports of the plant; the body must outlive the meter
  /// @param wanted terms to measure; the others stay 0
  StyleMeter(const P& plant, const typename P::Body& body, const Ports& ports, const FurtherTerms& wanted,
             float step_s)
      : plant_(plant),
        actuators_(ports.actuator_range.size()),
        wanted_(wanted),
        step_s_(step_s),
        mass_kg_(ports.mass_kg),
        length_m_(ports.length_m) {
    const Readings<P::kLanes> now = plant.Read();
    for (std::size_t j = 0; j < actuators_; ++j) sums_.rate_radps[j] = now.rate[j];
    if (!Wants(StyleTerm::kWork) && !Wants(StyleTerm::kPeakPower) && !Wants(StyleTerm::kCostOfTransport))
      return;
    muscles_.emplace(body, step_s);
    sums_.speed_radps = sums_.rate_radps;
    sums_.memory = muscles_->Begin(plant.Save());
  }

  /// Call after every step. The sum over the joints of one step is in single precision, the sum over the
  /// motion in double, so that a motion of two minutes loses nothing. @param pushes just before the step
  [[gnu::noinline]] void Add(std::span<const Push> pushes = {}) {
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
    if (muscles_) AddWork(now, pushes);
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
    if (!muscles_) return;
    const double work_j = sums_.work_j[lane];
    if (Wants(StyleTerm::kWork)) terms.work_j = static_cast<float>(work_j);
    if (Wants(StyleTerm::kPeakPower))
      terms.peak_power_wpkg = L::At(sums_.peak_j, lane) / (step_s_ * mass_kg_);
    if (Wants(StyleTerm::kCostOfTransport)) {
      const float way_m = std::max(std::abs(terms.travel_m), kLeastWay * length_m_);
      terms.cost_of_transport =
          static_cast<float>(work_j / static_cast<double>(mass_kg_ * kStandardGravity * way_m));
    }
  }

 private:
  /// Less travel than this, in longest rods, counts as this much: the cost of transport stays a number.
  static constexpr float kLeastWay = 0.01f;

  /// An impulse acts between the motion of the step before and that of its own step, so it works at the mean
  /// of both speeds.
  void AddWork([[maybe_unused]] const Readings<P::kLanes>& now,
               [[maybe_unused]] std::span<const Push> pushes) {
    F worked{};
    if constexpr (requires { muscles_->WorkOf(plant_.Save()); }) {
      worked = muscles_->WorkOf(plant_.Save());
    } else {
      const auto impulse = muscles_->ImpulsesOf(plant_.Save(), pushes, sums_.memory);
      for (std::size_t j = 0; j < actuators_; ++j) {
        const F speed = now.change[j] * (1.0f / step_s_);
        worked += L::Abs(impulse[j] * (0.5f * (sums_.speed_radps[j] + speed)));
        sums_.speed_radps[j] = speed;
      }
    }
    sums_.work_j += L::ToDouble(worked);
    sums_.peak_j = L::Max(sums_.peak_j, worked);
  }

  [[nodiscard]] bool Wants(StyleTerm term) const {
    return wanted_[static_cast<std::size_t>(term) - static_cast<std::size_t>(kPaperTerms)];
  }

  const P& plant_;
  std::size_t actuators_;
  FurtherTerms wanted_;
  float step_s_, mass_kg_, length_m_;
  std::optional<typename P::Muscles> muscles_;  // if their work is measured
  Sums sums_;
};

}  // namespace gaitsmith
