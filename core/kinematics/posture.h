// SPDX-License-Identifier: MIT
// A figure at one instant, whatever moves it: where its centre of mass is, how far it has turned, and how its
// joints are bent or where its nodes are. In double precision, because postures are interpolated and
// subtracted.
#pragma once

#include <cmath>
#include <vector>

#include "core/rollout/motion.h"

namespace gaitsmith {

struct WorldPoint {
  double x_m, y_m;

  /// How far it is from the origin [m].
  [[nodiscard]] double Length() const { return std::sqrt(x_m * x_m + y_m * y_m); }
};

struct Posture {
  double x_m = 0.0, y_m = 0.0;  // centre of mass, along the ground and above it
  double direction_rad = 0.0;   // of the root rod against the ground, whole turns included; or the best fit
  std::vector<double> angle_rad = {};  // of the joints, relative to the drawn ones (joints)
  std::vector<WorldPoint> nodes = {};  // of a figure of springs, from the centre of mass (nodes)
};

/// A recorded posture. @param frame of the motion
[[nodiscard]] Posture PostureAt(const Motion& motion, int frame);

/// Between two recorded frames, along cubics through four of them [Catmull 1974].
/// @param frame [0, frames - 1], need not be whole
[[nodiscard]] Posture PostureBetween(const Motion& motion, double frame);

/// The directions of all rods, as of the root (rods). That of a figure of springs alone.
[[nodiscard]] std::vector<double> DirectionsOf(const Skeleton&, const Posture&);

/// The endpoints in the skeleton's order, or the nodes (endpoints).
[[nodiscard]] std::vector<WorldPoint> EndpointsOf(const Skeleton&, const Posture&);

}  // namespace gaitsmith
