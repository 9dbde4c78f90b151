// SPDX-License-Identifier: MIT
// Trajectories, the third kind of controller: the target of each joint over time, as a uniform cubic
// B-spline. Nothing is sensed. The paper claims that rules are easier to find and survive more [Fukunaga
// 1994, section 1]; this is what they are compared with.
//
// A joint answers its target as it answers that of a rule, with the fastest response tau_min. So a trajectory
// can ask for no quicker motion than rules can. Curves that joints followed exactly were tried: with ten
// knots in a second Mr. Star-Man ran 157 m in ten seconds, where rules reach 20.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "core/control/stimulus_response.h"
#include "core/numeric/lane.h"
#include "core/numeric/scalar_math.h"
#include "core/signal/actuator_targets.h"

namespace gaitsmith {

/// The position of each number of a trajectory in its genome: knot after knot, an angle for each joint.
struct CurveShape {
  int knots = 10;  // [1, kMaxRules]
  int joints = 0;

  CurveShape(int knot_count, const PortCount& ports) : knots(knot_count), joints(ports.actuators) {}

  [[nodiscard]] std::size_t Knot(int knot) const {
    return static_cast<std::size_t>(knot) * static_cast<std::size_t>(joints);
  }
  [[nodiscard]] std::size_t Angle(int knot, int joint) const {
    return Knot(knot) + static_cast<std::size_t>(joint);
  }
  [[nodiscard]] std::size_t Genes() const { return Knot(knots); }
  [[nodiscard]] GeneGroups GroupsOf(int knot) const {
    return GeneGroups(Knot(knot)).Add("pose", GeneRole::kList, joints);
  }
};

/// The time of a trajectory's knots. A curve that repeats has one every period / knots, from 0; one that
/// rests has its first at 0 and its last at the end of the period, and begins and ends without speed.
class KnotTimes {
 public:
  KnotTimes(int knots, const SenseSpec& senses)
      : knots_(knots),
        period_(senses.period_steps),
        rests_(senses.at_end == CurveEnd::kRest),
        per_step_(static_cast<double>(rests_ ? knots - 1 : knots) / period_) {}

  /// Numbers of a curve's knots and their weights in its value, at some time.
  struct Mix {
    std::array<std::size_t, 4> knot;
    std::array<double, 4> weight;
  };

  /// @param time_steps since the controller took over, in steps, at least 0
  [[nodiscard]] Mix ValueAt(double time_steps) const {
    const double place = PlaceOf(time_steps);
    const int first = static_cast<int>(place);
    const double s = place - first, r = 1.0 - s;
    Mix mix;
    for (int i = 0; i < 4; ++i) mix.knot[static_cast<std::size_t>(i)] = Wrapped(first - 1 + i);
    mix.weight = {r * r * r / 6.0, (4.0 - 6.0 * s * s + 3.0 * s * s * s) / 6.0,
                  (4.0 - 6.0 * r * r + 3.0 * r * r * r) / 6.0, s * s * s / 6.0};
    return mix;
  }
  /// The knot nearest in time.
  [[nodiscard]] int NearestTo(double time_steps) const {
    const double place = PlaceOf(time_steps) + 0.5;
    const int nearest = static_cast<int>(place);  // rounded down
    return rests_ ? std::min(nearest, knots_ - 1) : nearest % knots_;
  }
  /// When a knot is, in steps from the start of the period.
  [[nodiscard]] double TimeOf(int knot) const { return per_step_ > 0.0 ? knot / per_step_ : 0.0; }

 private:
  /// The time in knots from the first, [0, knots).
  [[nodiscard]] double PlaceOf(double time_steps) const {
    if (rests_) return std::min(time_steps, static_cast<double>(period_)) * per_step_;
    const double periods = static_cast<double>(static_cast<int>(time_steps / period_));
    return (time_steps - periods * period_) * per_step_;
  }
  /// The knot of a place beyond the first or last: around a circle, or mirrored at the ends.
  [[nodiscard]] std::size_t Wrapped(int knot) const {
    if (!rests_) return static_cast<std::size_t>((knot + knots_) % knots_);
    if (knots_ == 1) return 0;
    const int mirrored = knot < 0 ? -knot : knot >= knots_ ? 2 * (knots_ - 1) - knot : knot;
    return static_cast<std::size_t>(std::clamp(mirrored, 0, knots_ - 1));
  }

  int knots_;
  int period_;
  bool rests_;
  double per_step_;  // knots
};

/// W trajectories of one shape side by side, decoded.
template <int W>
class JointCurves {
  using L = Lane<W>;
  using F = typename L::F;

 public:
  /// @param genomes 1 to W of them, all of this shape; missing lanes repeat the last one
  /// @param limits  least and greatest angle of each joint [rad], shape.joints pairs
  /// @param step_s  time step
  JointCurves(const CurveShape& shape, const SenseSpec& senses,
              std::span<const std::span<const Gene>> genomes, std::span<const std::array<float, 2>> limits,
              float step_s)
      : shape_(shape),
        times_(shape.knots, senses),
        decay_(static_cast<float>(Exp(-static_cast<double>(step_s) / static_cast<double>(senses.tau_min_s)))),
        inverse_tau_(1.0f / senses.tau_min_s),
        angle_(shape.Genes()) {
    for (int lane = 0; lane < W; ++lane) {
      const auto& genes = genomes[std::min(static_cast<std::size_t>(lane), genomes.size() - 1)];
      for (int knot = 0; knot < shape.knots; ++knot) {
        for (int joint = 0; joint < shape.joints; ++joint) {
          const std::size_t at = shape.Angle(knot, joint);
          const auto& [low, high] = limits[static_cast<std::size_t>(joint)];
          angle_[at][lane] = Decode(genes[at], low, high);
        }
      }
    }
  }

  /// Sets the targets of the step that begins, the curves' values in its middle.
  /// @param steps since the curves took over
  void Follow(int steps, ActuatorTargets<W>& targets) const {
    const KnotTimes::Mix mix = times_.ValueAt(steps + kMidStep);
    for (std::size_t j = 0; j < static_cast<std::size_t>(shape_.joints); ++j) {
      F target{};
      for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t at = mix.knot[i] * static_cast<std::size_t>(shape_.joints) + j;
        target += angle_[at] * static_cast<float>(mix.weight[i]);
      }
      targets.target[j] = target;
      targets.decay[j] = L::Splat(decay_);
      targets.inverse_tau[j] = L::Splat(inverse_tau_);
    }
  }

  [[nodiscard]] const KnotTimes& Times() const { return times_; }
  /// [rad]
  [[nodiscard]] float AngleOf(int knot, int joint, int lane) const {
    return L::At(angle_[shape_.Angle(knot, joint)], lane);
  }
  [[nodiscard]] float Decay() const { return decay_; }

  static constexpr double kMidStep = 0.5;

 private:
  CurveShape shape_;
  KnotTimes times_;
  float decay_, inverse_tau_;
  std::vector<F> angle_;  // [rad] (knots x joints)
};

}  // namespace gaitsmith
