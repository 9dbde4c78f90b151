// SPDX-License-Identifier: MIT
// How springs move nodes in a substep: leapfrog [Hairer Lubich Wanner 2003]. Positions and the velocities of
// the last half substep give impulses, which change the velocities, which move the positions. Impulses are
// along the springs and opposite at their ends, so momentum and angular momentum stay as they are. All
// springs act on the same positions and velocities, so their order does not matter.
//
// Why damping gives no energy, however strong (LatticeWorld limits it): let D v be the velocities after
// damping alone, A stiffness over mass times the squared substep, u the way of a substep, and products
// weighted by masses. Then u' = D u - A x. V = (u, (1 + D) u) / 2 + (x - u, A x) is an energy but for a
// factor, and changes by -(u + u', (1 - D)(u + u')) / 2. D is symmetric and within [0, 1], so V never grows,
// and it is positive as substeps are so short that A <= 1. This holds for small vibrations of springs that
// are not under pressure.
#pragma once

#include "core/springs/lattice_state.h"
#include "core/springs/lattice_world.h"

namespace gaitsmith {

/// Added to squared lengths, so that nodes at one place have a direction [m^2].
inline constexpr float kLeastSquaredLength = 1e-12f;

/// Gives the nodes the impulses of all springs in one substep.
/// @param share  of the substep that muscles' work counts now: half at the ends of a step, for the
/// trapezoidal rule
/// @return greatest stretch: length over drawn length
template <int W>
[[gnu::always_inline]] inline typename Lane<W>::F PullSprings(const Lattice& body, const LatticeWorld& world,
                                                              float share, LatticeState<W>& s) {
  using L = Lane<W>;
  using F = typename L::F;
  F stretch{};
  typename LatticeState<W>::Points impulse_x{}, impulse_y{};
  for (std::size_t i = 0; i < body.links; ++i) {
    const Lattice::Link& link = body.link[i];
    const std::size_t a = link.from, b = link.to;
    const F x = s.x[b] - s.x[a], y = s.y[b] - s.y[a];
    const F length = L::Sqrt((x * x + y * y) + kLeastSquaredLength);
    const F inverse = 1.0f / length;
    const F along_x = x * inverse, along_y = y * inverse;
    stretch = L::Max(length * (1.0f / link.drawn_m), stretch);
    F beyond;  // its rest
    if (link.muscle < 0) {
      beyond = length - link.drawn_m * link.rest;
    } else {
      const auto j = static_cast<std::size_t>(link.muscle);
      beyond = length - link.drawn_m * s.rest[j];
      s.pulled_m[j] += share * beyond;
    }
    const F speed =
        (s.velocity_x[b] - s.velocity_x[a]) * along_x + (s.velocity_y[b] - s.velocity_y[a]) * along_y;
    const F impulse = world.stiffness_ns[i] * beyond + world.damping_kg[i] * speed;
    const F pull_x = impulse * along_x, pull_y = impulse * along_y;
    impulse_x[a] += pull_x;
    impulse_y[a] += pull_y;
    impulse_x[b] -= pull_x;
    impulse_y[b] -= pull_y;
  }
  for (std::size_t k = 0; k < body.nodes; ++k) {
    s.velocity_x[k] += impulse_x[k] * body.inverse_kg[k];
    s.velocity_y[k] += impulse_y[k] * body.inverse_kg[k];
  }
  return stretch;
}

}  // namespace gaitsmith
