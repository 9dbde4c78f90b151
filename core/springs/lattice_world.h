// SPDX-License-Identifier: MIT
// What all figures of springs in a simulation share, as the numbers that a substep needs.
#pragma once

#include <array>

#include "core/numeric/scalar_math.h"
#include "core/springs/lattice.h"
#include "core/world/environment.h"

namespace gaitsmith {

struct LatticeWorld {
  /// @param step of the plant [s]; a step of kStep has the lattice's substeps, a finer one as many
  LatticeWorld(const Lattice& body, const Environment& environment, float step)
      : substeps(body.substeps),
        substep_share(1.0f / static_cast<float>(body.substeps)),
        substep_s(step / static_cast<float>(body.substeps)),
        inverse_substep(1.0f / substep_s),
        friction(environment.friction) {
    weight_n =
        body.total_kg * environment.gravity_mps2 * Tilt(environment.gravity_mps2, environment.slope_rad);
    for (std::size_t i = 0; i < body.links; ++i) {
      const Lattice::Link& link = body.link[i];
      // A pair's speed along its spring decays as damping alone lets it, exactly. No damping is too strong.
      const double lost =
          1.0 - Exp(-0.5 * static_cast<double>(substep_s * link.damping_nspm / link.reduced_kg));
      damping_kg[i] = static_cast<float>(lost) * link.reduced_kg;
      stiffness_ns[i] = substep_s * link.stiffness_npm;
    }
  }

  /// Sets gravity for ground of this slope. @return the slope's cosine
  float Tilt(float gravity_mps2, float slope_rad) {
    const SineCosine slope = SinCos(slope_rad);
    fall_x = -gravity_mps2 * slope.sine * substep_s;
    fall_y = -gravity_mps2 * slope.cosine * substep_s;
    return slope.cosine;
  }

  int substeps;
  float substep_share;  // of a step; exact, because the number of substeps is a power of two
  float substep_s, inverse_substep;
  float fall_x, fall_y;                           // change of velocity by gravity in a substep [m/s]
  float weight_n;                                 // normal to the ground at its mean slope
  float friction;                                 // Coulomb coefficient
  std::array<float, kMaxSprings> damping_kg{};    // of half a substep: impulse per speed along the spring
  std::array<float, kMaxSprings> stiffness_ns{};  // of a substep: impulse per length [N s/m]
};

}  // namespace gaitsmith
