// SPDX-License-Identifier: MIT
// How well two instants of a motion fit, if the second is to become the first, a cycle later.
#pragma once

#include <vector>

#include "core/kinematics/limb_pairs.h"

namespace gaitsmith {

class CycleEnds {
 public:
  /// @param motion must outlive this @param pairs limbs that take each other's part from the first to the
  /// second
  CycleEnds(const Motion& motion, const LimbPairs& pairs);

  // Of every function, `first` is a frame and `second` need not be whole, 1 <= first < second <= frames - 1.

  /// What a cut there would cost: the gap, how far feet would slide, and how much velocities would jump, each
  /// weighed [longest rod].
  [[nodiscard]] double Misfit(int first, double second) const;
  /// The farthest that an endpoint is from where it was [longest rod]. The place along the ground does not
  /// count.
  [[nodiscard]] double GapRods(int first, double second) const { return At(first, second).gap; }
  /// Whole turns from the first to the second.
  [[nodiscard]] int Turns(int first, double second) const;
  /// How far feet that bear load at both instants have come along the ground, on average; the centre of mass,
  /// if none does [m].
  [[nodiscard]] double DistanceM(int first, double second) const { return At(first, second).distance_m; }

 private:
  struct Fit {
    double gap = 0.0, slide = 0.0, distance_m = 0.0;
  };
  [[nodiscard]] Fit At(int first, double second) const;
  [[nodiscard]] std::vector<WorldPoint> PointsAt(double frame) const;
  [[nodiscard]] const std::vector<WorldPoint>& Points(int frame) const {
    return points_[static_cast<std::size_t>(frame)];
  }

  const Motion& motion_;
  LimbPairs pairs_;
  double length_m_;
  std::vector<std::vector<WorldPoint>> points_;  // of each frame, as it was recorded
};

}  // namespace gaitsmith
