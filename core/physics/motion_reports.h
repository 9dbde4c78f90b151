// SPDX-License-Identifier: MIT
// What the plants of all figures report in the same way, from the parts that their states have in common.
#pragma once

#include <cmath>

#include "core/numeric/scalar_math.h"
#include "core/physics/skeleton.h"
#include "core/physics/terms.h"
#include "core/physics/trajectory_hash.h"

namespace gaitsmith {

/// @param start_turn_rad of the root rod, where measuring began
template <class State>
Terms TermsOf(const State& s, int lane, double start_turn_rad) {
  Terms terms;
  terms.travel_m = static_cast<float>(s.distance_m[lane]);
  terms.start_height_m = s.start_height_m[lane];
  terms.max_cm_height_m = s.greatest_height_m[lane];
  terms.slip_sum_m = s.slip_m[lane];
  const double turns = (s.turn_rad[lane] - start_turn_rad) / (2.0 * kPi);
  terms.rotations = static_cast<float>(turns < 0.0 ? -turns : turns);
  terms.broke_physics =
      s.broken[lane] != 0 || !std::isfinite(s.distance_m[lane]) || !std::isfinite(s.height_m[lane]);
  return terms;
}

/// Adds one figure's positions to a hash.
template <class State>
void AddPositions(const Skeleton& skeleton, const State& s, int lane, TrajectoryHash& hash) {
  hash.Add(s.distance_m[lane]);
  hash.Add(s.height_m[lane]);
  hash.Add(s.turn_rad[lane]);
  for (std::size_t j = 0; j < static_cast<std::size_t>(skeleton.joints); ++j) hash.Add(s.angle_rad[j][lane]);
}

}  // namespace gaitsmith
