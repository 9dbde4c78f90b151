// SPDX-License-Identifier: MIT
// Level ground under the nodes of W figures of springs, in one substep. A node is a point of its own mass, so
// each contact is solved alone, and exactly: it does not end below the ground [Stewart Trinkle 1996], and
// friction stops it or is as strong as Coulomb says.
#pragma once

#include "core/springs/lattice_state.h"
#include "core/springs/lattice_world.h"

namespace gaitsmith {

/// Moves the nodes by one substep, with the ground's impulses. @param slide in and out: path of each node
/// while it bore load in this step [m]
template <int W>
[[gnu::always_inline]] inline void MoveOnFloor(const Lattice& body, const LatticeWorld& world,
                                               typename LatticeState<W>::Points& slide, LatticeState<W>& s) {
  using L = Lane<W>;
  using F = typename L::F;
  const float h = world.substep_s;
  for (std::size_t k = 0; k < body.nodes; ++k) {
    const F vx = s.velocity_x[k] + world.fall_x, vy = s.velocity_y[k] + world.fall_y;
    const F y = s.y[k] + h * vy;
    const auto below = s.height_m + y < 0.0f;
    if (L::Any(below)) {
      const float mass = body.mass_kg[k];
      const F gap = L::Max(s.height_m + s.y[k], F{});
      const F landing = L::Select(below, gap * -world.inverse_substep, vy);  // just reaches the ground
      const F normal = mass * (landing - vy);
      const F most = (world.friction * body.inverse_kg[k]) * normal;
      const F slowed = L::Max(L::Abs(vx) - most, F{});
      const F sliding = L::Select(below, L::Select(vx < 0.0f, -slowed, slowed), vx);
      const F tangent = mass * (sliding - vx);
      s.velocity_x[k] = sliding;
      s.velocity_y[k] = landing;
      s.normal[k] += normal;
      s.tangent[k] += tangent;
      const F path = h * sliding;
      slide[k] += L::Select(below, L::Abs(path), F{});
      s.normal_work_j += normal * landing;
      s.friction_work_j += tangent * sliding;
      s.friction_gain_j += L::Max(tangent * sliding, F{});
      s.x[k] += path;
      s.y[k] = L::Select(below, -s.height_m, y);
    } else {
      s.velocity_x[k] = vx;
      s.velocity_y[k] = vy;
      s.x[k] += h * vx;
      s.y[k] = y;
    }
  }
}

}  // namespace gaitsmith
