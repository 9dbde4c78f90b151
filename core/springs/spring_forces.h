// SPDX-License-Identifier: MIT
// How springs move nodes in a substep: leapfrog [Hairer Lubich Wanner 2003]. Velocities of the last half
// substep are damped, then get the impulses of the positions, then move these. Impulses are along the springs
// and opposite at their ends, so momentum and angular momentum stay as they are.
//
// Springs are damped one after another, from the first to the last and back, each time by half. Such a sweep
// and its reverse are a symmetric operator, so damping gives no motion energy, however strong. For let d in
// [0, 1] and a >= 0 be the quotients, in a motion that grows by z in each substep, of this operator and of
// stiffness over mass times the squared substep. Both are real, and z^2 - (1 + d - a) z + d = 0 has no root
// beyond 1 while a <= 2 (1 + d). Substeps are so short that a <= 1. One sweep alone has a complex d, and if
// masses differ much strong damping makes motions grow. Impulses come after it so that figures rest where
// their springs bear them, whatever the damping.
#pragma once

#include "core/springs/lattice_state.h"
#include "core/springs/lattice_world.h"

namespace gaitsmith {

/// Added to squared lengths, so that nodes at one place have a direction [m^2].
inline constexpr float kLeastSquaredLength = 1e-12f;

/// What the springs of W figures do in a substep.
template <int W>
struct SpringPulls {
  using F = typename Lane<W>::F;
  std::array<F, kMaxSprings> along_x, along_y;  // unit vectors from their first nodes to their second
  std::array<F, kMaxSprings> impulse;           // positive pulls the nodes together [N s]
};

/// Gives both nodes of a spring an impulse along it [N s].
template <int W>
[[gnu::always_inline]] inline void PullTogether(const Lattice& body, const SpringPulls<W>& pulls,
                                                std::size_t spring, const typename Lane<W>::F& impulse,
                                                LatticeState<W>& s) {
  const std::size_t a = body.link[spring].from, b = body.link[spring].to;
  const auto impulse_x = impulse * pulls.along_x[spring], impulse_y = impulse * pulls.along_y[spring];
  s.velocity_x[a] += impulse_x * body.inverse_kg[a];
  s.velocity_y[a] += impulse_y * body.inverse_kg[a];
  s.velocity_x[b] -= impulse_x * body.inverse_kg[b];
  s.velocity_y[b] -= impulse_y * body.inverse_kg[b];
}

/// Lets a spring's speed decay for half a substep.
template <int W>
[[gnu::always_inline]] inline void DampSpring(const Lattice& body, const LatticeWorld& world,
                                              const SpringPulls<W>& pulls, std::size_t spring,
                                              LatticeState<W>& s) {
  const std::size_t a = body.link[spring].from, b = body.link[spring].to;
  const auto speed = (s.velocity_x[b] - s.velocity_x[a]) * pulls.along_x[spring] +
                     (s.velocity_y[b] - s.velocity_y[a]) * pulls.along_y[spring];
  PullTogether<W>(body, pulls, spring, world.damping_kg[spring] * speed, s);
}

/// Damps the springs' speeds, then gives the nodes the impulses of all springs in one substep.
/// @param share  of the substep that muscles' work counts now: half at the ends of a step, for the
/// trapezoidal rule
/// @return greatest stretch: length over drawn length
template <int W>
[[gnu::always_inline]] inline typename Lane<W>::F PullSprings(const Lattice& body, const LatticeWorld& world,
                                                              float share, LatticeState<W>& s) {
  using L = Lane<W>;
  using F = typename L::F;
  F stretch{};
  SpringPulls<W> pulls;
  for (std::size_t i = 0; i < body.links; ++i) {
    const Lattice::Link& link = body.link[i];
    const F x = s.x[link.to] - s.x[link.from], y = s.y[link.to] - s.y[link.from];
    const F length = L::Sqrt((x * x + y * y) + kLeastSquaredLength);
    const F inverse = 1.0f / length;
    pulls.along_x[i] = x * inverse;
    pulls.along_y[i] = y * inverse;
    stretch = L::Max(length * (1.0f / link.drawn_m), stretch);
    F beyond;  // its rest
    if (link.muscle < 0) {
      beyond = length - link.drawn_m * link.rest;
    } else {
      const auto j = static_cast<std::size_t>(link.muscle);
      beyond = length - link.drawn_m * s.rest[j];
      s.pulled_m[j] += share * beyond;
    }
    pulls.impulse[i] = world.stiffness_ns[i] * beyond;
    DampSpring<W>(body, world, pulls, i, s);
  }
  for (std::size_t i = body.links; i-- > 0;) DampSpring<W>(body, world, pulls, i, s);
  for (std::size_t i = 0; i < body.links; ++i) PullTogether<W>(body, pulls, i, pulls.impulse[i], s);
  return stretch;
}

}  // namespace gaitsmith
