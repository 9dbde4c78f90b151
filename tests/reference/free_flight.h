// SPDX-License-Identifier: MIT
// An independent model of a figure in the air, in double precision and by other methods than core's: world
// positions of rods from absolute angles, momentum by summing over rods, time by fourth-order Runge-Kutta
// with a hundredth of core's step.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/physics/skeleton.h"

namespace gaitsmith::test {

class FreeFlight {
 public:
  using Angles = std::vector<double>;
  explicit FreeFlight(const Skeleton& bones) : bones_(bones) {}

  struct Shape {
    double inertia;   // about the centre of mass [kg m^2]
    double momentum;  // angular momentum of the joints' motion with the root held still [kg m^2/s]
  };
  [[nodiscard]] Shape ShapeAt(const Angles& angle, const Angles& rate) const;

  /// Turn of the root after `seconds`. The joints move from rest at 0 towards `target` as critically damped
  /// springs.
  [[nodiscard]] double Turn(const Angles& target, double tau_s, double momentum, double seconds) const;

 private:
  Skeleton bones_;
};

}  // namespace gaitsmith::test
