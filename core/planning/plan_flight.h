// SPDX-License-Identifier: MIT
// The flights of a plan: the times at which nothing stands.
#pragma once

#include <vector>

#include "core/spacetime/planned_motion.h"

namespace gaitsmith {

struct Flight {
  int start, middle, landing;  // steps
  bool lies;                   // a rod lands along the ground, and has its direction
};

/// How a flight goes, which is decided when it begins: nothing but gravity acts in between.
struct Course {
  PlannedMotion::Vector middle;  // of the centre of mass, in the middle of the flight [m]
  double turn;                   // since the start, at the landing [rad]
};

/// Of three steps or more, in their order.
[[nodiscard]] std::vector<Flight> FlightsOf(const PlanScene&);
[[nodiscard]] Course CourseOf(const Flight&, const PlannedMotion&);

}  // namespace gaitsmith
