// SPDX-License-Identifier: MIT
// What all figures of a simulation share: environment and mass, as the numbers that a step needs.
#pragma once

#include "core/numeric/scalar_math.h"
#include "core/physics/skeleton.h"
#include "core/world/environment.h"

namespace gaitsmith {

struct World {
  World(const Skeleton& skeleton, const Environment& environment, float step)
      : step_s(step),
        inverse_step(1.0f / step),
        friction(environment.friction),
        mass_kg(skeleton.mass_kg),
        inverse_mass(1.0f / skeleton.mass_kg) {
    weight_n = mass_kg * environment.gravity_mps2 * Tilt(environment.gravity_mps2, environment.slope_rad);
    max_ground_work_j = kMaxGroundWork * mass_kg * kStandardGravity * skeleton.longest_rod_m;
  }

  /// Sets gravity for ground of this slope. @return the slope's cosine
  float Tilt(float gravity_mps2, float slope_rad) {
    const SineCosine slope = SinCos(slope_rad);
    fall_x = -gravity_mps2 * slope.sine * step_s;
    fall_y = -gravity_mps2 * slope.cosine * step_s;
    return slope.cosine;
  }

  float step_s, inverse_step;
  float fall_x, fall_y;  // change of velocity by gravity in one step [m/s]
  float weight_n;        // normal to the ground at its mean slope
  float friction;        // Coulomb coefficient
  float mass_kg, inverse_mass;
  float max_ground_work_j;  // see kMaxGroundWork
};

}  // namespace gaitsmith
