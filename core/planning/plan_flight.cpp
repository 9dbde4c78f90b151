// SPDX-License-Identifier: MIT
#include "core/planning/plan_flight.h"

#include <algorithm>

namespace gaitsmith {

std::vector<Flight> FlightsOf(const PlanScene& scene) {
  const auto stands = [&](int endpoint, int step) {
    return std::ranges::any_of(scene.plan.stances, [&](const Stance& one) {
      return one.endpoint == endpoint && one.first_step <= step && step <= one.last_step;
    });
  };
  const auto flies = [&](int step) {
    for (int k = 0; k < scene.skeleton.endpoints; ++k)
      if (stands(k, step)) return false;
    return true;
  };
  std::vector<Flight> flights;
  int began = 0;
  for (int step = 1; step <= scene.plan.steps; ++step) {
    if (flies(step)) continue;
    if (flies(step - 1) && step - began > 2) {
      Flight& flight = flights.emplace_back(began, (began + step) / 2, step, false);
      for (int rod = 0; rod < scene.skeleton.rods; ++rod)
        flight.lies =
            flight.lies || (stands(scene.skeleton.limbs[static_cast<std::size_t>(rod)].start, step) &&
                            stands(rod + 1, step));
    }
    began = step;
  }
  return flights;
}

Course CourseOf(const Flight& flight, const PlannedMotion& planned) {
  const auto step_s = static_cast<double>(kStep);
  return {planned.At(flight.middle * step_s).centre,
          planned.At(flight.landing * step_s).direction_rad[0] -
              static_cast<double>(planned.Scene().skeleton.start_angle_rad)};
}

}  // namespace gaitsmith
