// SPDX-License-Identifier: MIT
// How springs move nodes in a substep: leapfrog [Hairer Lubich Wanner 2003]. Positions give impulses, which
// change the velocities of the half substep, which move the positions. Impulses are along the springs and
// opposite at their ends, so momentum and angular momentum stay as they are.
#pragma once

#include "core/springs/lattice_state.h"
#include "core/springs/lattice_world.h"

namespace gaitsmith {

/// Added to squared lengths, so that nodes at one place have a direction [m^2].
inline constexpr float kLeastSquaredLength = 1e-12f;

/// Gives the nodes the impulses of all springs in one substep, then damps each spring's speed.
/// @param share  of the substep that muscles' work counts now: half at the ends of a step, for the
/// trapezoidal rule
/// @param backwards from the last spring to the first: damping that went the same way each time would drift
/// to one side
/// @return greatest stretch: length over drawn length
template <int W>
[[gnu::always_inline]] inline typename Lane<W>::F PullSprings(const Lattice& body, const LatticeWorld& world,
                                                              float share, bool backwards,
                                                              LatticeState<W>& s) {
  using L = Lane<W>;
  using F = typename L::F;
  F stretch{};
  for (std::size_t n = 0; n < body.links; ++n) {
    const std::size_t i = backwards ? body.links - 1 - n : n;
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
    const F impulse_x = impulse * along_x, impulse_y = impulse * along_y;
    s.velocity_x[a] += impulse_x * body.inverse_kg[a];
    s.velocity_y[a] += impulse_y * body.inverse_kg[a];
    s.velocity_x[b] -= impulse_x * body.inverse_kg[b];
    s.velocity_y[b] -= impulse_y * body.inverse_kg[b];
  }
  return stretch;
}

}  // namespace gaitsmith
