// SPDX-License-Identifier: MIT
// What all figures of springs in a simulation share, as the numbers that a substep needs.
#pragma once

#include <algorithm>
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
    SetSprings(body);
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
  float fall_x, fall_y;  // change of velocity by gravity in a substep [m/s]
  float weight_n;        // normal to the ground at its mean slope
  float friction;        // Coulomb coefficient
  // Of each spring in a substep.
  std::array<float, kMaxSprings> damping_kg{};    // impulse per speed along it
  std::array<float, kMaxSprings> stiffness_ns{};  // impulse per length [N s/m]

 private:
  /// Each spring takes what would be right if it were alone, but no more than makes all of a figure's speeds
  /// vanish together: its share of its nodes' masses, each divided in proportion to its springs' damping.
  void SetSprings(const Lattice& body) {
    std::array<double, kMaxPoints> rate{};  // of all damping at a node [1/s]
    for (std::size_t i = 0; i < body.links; ++i) {
      for (const std::size_t node : {body.link[i].from, body.link[i].to})
        rate[node] +=
            static_cast<double>(body.link[i].damping_nspm) * static_cast<double>(body.inverse_kg[node]);
    }
    for (std::size_t i = 0; i < body.links; ++i) {
      const Lattice::Link& link = body.link[i];
      stiffness_ns[i] = substep_s * link.stiffness_npm;
      if (link.damping_nspm == 0.0f) continue;
      const double damping = static_cast<double>(link.damping_nspm);
      const double lost = 1.0 - Exp(-static_cast<double>(substep_s * link.damping_nspm / link.reduced_kg));
      const double most = damping / (rate[link.from] + rate[link.to]);
      damping_kg[i] = static_cast<float>(std::min(lost * static_cast<double>(link.reduced_kg), most));
    }
  }
};

}  // namespace gaitsmith
