// SPDX-License-Identifier: MIT
// Measures the traits of a motion that are not style terms: how the figure uses the ground. It only reads the
// plant, as StyleMeter does.
#pragma once

#include <array>
#include <cmath>

#include "core/rollout/plant.h"
#include "core/signal/traits.h"

namespace gaitsmith {

template <Plant P>
class GaitMeter {
 public:
  /// @param plant that has not stepped yet; must outlive the meter
  /// @param size_m of the figure, > 0
  GaitMeter(const P& plant, const PortCount& ports, float size_m, float step_s)
      : plant_(plant), ports_(ports), size_m_(size_m), step_s_(step_s) {}

  /// Call after every step.
  void Add() {
    ++steps_;
    const auto now = plant_.Read();
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      Gait& gait = gaits_[lane];
      const auto at = static_cast<int>(lane);
      int bearing = 0;
      for (std::size_t k = 0; k < static_cast<std::size_t>(ports_.contacts); ++k) {
        const bool bears = now.impulse[k][at] > 0.0f;
        bearing += bears ? 1 : 0;
        // Contact flickers, so a foot must have been off the ground for a while to come down.
        if (bears && gait.unloaded[k] >= kFlicker) ++gait.touchdowns;
        gait.unloaded[k] = bears ? 0 : gait.unloaded[k] + 1;
      }
      gait.borne += bearing;
      gait.airborne += bearing == 0 ? 1 : 0;
      const double height = static_cast<double>((*now.height)[at]);
      gait.height += height;
      gait.height_squared += height * height;
      float quickest = std::abs((*now.rise)[at]) / size_m_;
      for (std::size_t j = 0; j < static_cast<std::size_t>(ports_.actuators); ++j)
        quickest = std::max(quickest, std::abs(now.rate[j][at]));
      gait.still += quickest < kStillRate ? 1 : 0;
    }
  }

  /// @param terms of the lane, with the free further terms
  [[nodiscard]] Traits TraitsOf(int lane, const Terms& terms) const {
    const Gait& gait = gaits_[static_cast<std::size_t>(lane)];
    const auto steps = static_cast<float>(std::max(1, steps_));
    const float seconds = steps * step_s_, metres = size_m_;
    const auto share = [&](int count) { return static_cast<float>(count) / steps; };
    const double mean = gait.height / static_cast<double>(steps);
    const double spread = std::max(0.0, gait.height_squared / static_cast<double>(steps) - mean * mean);
    Traits traits{};
    const auto put = [&](Trait trait, float value) { traits[static_cast<std::size_t>(trait)] = value; };
    put(Trait::kSpeed, terms.travel_m / metres / seconds);
    put(Trait::kHeight, (terms.max_cm_height_m - terms.start_height_m) / metres);
    put(Trait::kSlip, terms.slip_sum_m / metres / seconds);
    put(Trait::kTurns, terms.rotations / seconds);
    put(Trait::kEffort, terms.effort_rad / seconds / static_cast<float>(std::max(1, ports_.actuators)));
    put(Trait::kUpright, terms.upright);
    put(Trait::kSmoothness, terms.smoothness_radps2);
    put(Trait::kHeadHeight, terms.head_height_m / metres);
    put(Trait::kBounce, static_cast<float>(std::sqrt(spread)) / metres);
    put(Trait::kAir, share(gait.airborne));
    put(Trait::kSupport, share(gait.borne) / static_cast<float>(std::max(1, ports_.contacts)));
    put(Trait::kSteps, static_cast<float>(gait.touchdowns) / seconds);
    put(Trait::kStill, share(gait.still));
    return traits;
  }

 private:
  static constexpr auto kLanes = static_cast<std::size_t>(P::kLanes);
  static constexpr int kFlicker = 5;          // steps
  static constexpr float kStillRate = 0.05f;  // [rad/s], [sizes/s]

  struct Gait {
    std::array<int, kMaxContacts> unloaded{};  // steps since each contact bore load
    int touchdowns = 0, airborne = 0, borne = 0, still = 0;
    double height = 0.0, height_squared = 0.0;
  };

  const P& plant_;
  PortCount ports_;
  float size_m_, step_s_;
  int steps_ = 0;
  std::array<Gait, kLanes> gaits_{};
};

}  // namespace gaitsmith
