// SPDX-License-Identifier: MIT
// Drawn ground in a plan: where endpoints stand on it, and a smooth cover over it that everything in the air
// keeps above.
#pragma once

#include <span>
#include <vector>

#include "core/world/environment.h"

namespace gaitsmith {

class PlanGround {
 public:
  /// @param ground   must be valid; empty: level
  /// @param length_m unit of length
  PlanGround(std::span<const Corner> ground, double length_m);

  struct Height {
    double value = 0.0, slope = 0.0, bend = 0.0;
  };
  /// Of the ground itself. [units]
  [[nodiscard]] Height At(double x) const;
  /// Of the cover: a cubic spline each of whose coefficients is the highest ground nearby, and a little more
  /// where that falls away, because the simulator plays a plan some centimetres lower. So it is nowhere below
  /// the ground, and three times kGrain beside a step already as high.
  [[nodiscard]] Height CoverAt(double x) const;
  [[nodiscard]] bool Level() const { return corners_.empty(); }

  /// Between the cover's coefficients [longest rods].
  static constexpr double kGrain = 0.05;
  /// Above an edge, at most [longest rods].
  static constexpr double kSpare = 0.1;

 private:
  struct Point {
    double x, y;
  };
  [[nodiscard]] double CoefficientAt(double centre) const;

  std::vector<Point> corners_;
};

}  // namespace gaitsmith
