// SPDX-License-Identifier: MIT
// Heights of a ground for pictures, at any place: motions that fail may report places far away, or none.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/world/terrain.h"

namespace gaitsmith {

/// The ground's height below a place; 0 for a place that is not a number [m].
[[nodiscard]] inline double HeightBelow(const Terrain& terrain, double x_m) {
  constexpr double kFar = 1e6;  // a drawn ground is level there
  if (terrain.Level() || std::isnan(x_m)) return 0.0;
  return terrain.HeightAt(std::clamp(x_m, -kFar, kFar));
}

/// The lowest ground between two places [m].
[[nodiscard]] inline double LowestBetween(const Terrain& terrain, double left_m, double right_m) {
  double lowest = std::min(HeightBelow(terrain, left_m), HeightBelow(terrain, right_m));
  if (terrain.Level()) return lowest;
  for (const Terrain::Face& face : terrain.FacesBetween(left_m, right_m)) {
    if (face.x >= left_m) lowest = std::min(lowest, face.y);
  }
  return lowest;
}

}  // namespace gaitsmith
