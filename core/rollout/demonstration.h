// SPDX-License-Identifier: MIT
// What a person shows a figure: a way for its centre of mass, and a pose at a moment. How far a motion is
// from both is measured like the other style terms; docs/style.md has the formulas.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "core/physics/terms.h"

namespace gaitsmith {

inline constexpr int kMaxWayPoints = 32;

/// Where the centre of mass should be at a step.
struct WayPoint {
  int step = 0;      // of the scored motion, [0, kMaxSteps]
  float x_m = 0.0f;  // along the ground from the centre's start, rightward positive
  float y_m = 0.0f;  // above the ground
  bool operator==(const WayPoint&) const = default;
};

struct Demonstration {
  // Out of line, because every copy of a task, a problem or a document has one: a kilobyte of the page.
  Demonstration();
  Demonstration(const Demonstration&);
  Demonstration(Demonstration&&) noexcept;
  Demonstration& operator=(const Demonstration&);
  Demonstration& operator=(Demonstration&&) noexcept;
  ~Demonstration();

  std::vector<WayPoint> way;    // by step, no two at the same; empty: no way is shown
  int pose_step = 1;            // of the scored motion, [1, kMaxSteps]
  float pose_turn_rad = 0.0f;   // direction of the root rod, counterclockwise from the ground's right
  std::vector<float> pose_rad;  // angle of each joint; empty: no pose is shown
  bool operator==(const Demonstration&) const;

  /// The way at a step from its first point to its last, straight between two points. The way has points.
  [[nodiscard]] std::array<double, 2> WayAt(int step) const;
};

/// A turn without whole turns, [-pi, pi].
[[nodiscard]] double WithoutWholeTurns(double turn_rad);

/// Measures one motion against a demonstration, step by step.
class DemonstrationMeter {
 public:
  /// @param shown must outlive the meter
  explicit DemonstrationMeter(const Demonstration& shown) : shown_(&shown) {}

  /// Call after every step of the scored motion. @param x_m, y_m as in WayPoint @param turn_rad direction of
  /// the root rod, whole turns included @param angle of a joint by its index [rad]
  template <class Angle>
  void Add(double x_m, double y_m, double turn_rad, Angle angle) {
    ++step_;
    if (!shown_->way.empty() && step_ >= shown_->way.front().step && step_ <= shown_->way.back().step)
      AddGap(x_m, y_m);
    if (shown_->pose_rad.empty() || step_ != shown_->pose_step) return;
    double gap = std::abs(WithoutWholeTurns(turn_rad - static_cast<double>(shown_->pose_turn_rad)));
    for (std::size_t joint = 0; joint < shown_->pose_rad.size(); ++joint)
      gap += std::abs(static_cast<double>(angle(joint)) - static_cast<double>(shown_->pose_rad[joint]));
    pose_gap_rad_ = gap / static_cast<double>(shown_->pose_rad.size() + 1);
  }

  /// Writes the terms so far, never -0.
  void Put(Terms& terms) const {
    terms.on_way_m = way_steps_ == 0 ? 0.0f : static_cast<float>(0.0 - way_gaps_m_ / way_steps_);
    terms.in_pose_rad = static_cast<float>(0.0 - pose_gap_rad_);
  }

 private:
  void AddGap(double x_m, double y_m);

  const Demonstration* shown_;
  int step_ = 0, way_steps_ = 0;
  double way_gaps_m_ = 0.0, pose_gap_rad_ = 0.0;
};

}  // namespace gaitsmith
