// SPDX-License-Identifier: MIT
// Contact of endpoints with the ground: inelastic, Coulomb friction, non-penetration, as one complementarity
// problem on velocities per step [Stewart Trinkle 1996], solved by projected Gauss-Seidel with accumulated
// impulses [Catto 2005].
//
// For an endpoint with arm r from the centre of mass (W figures side by side, each one rigid body at this
// instant):
//   normal   0 <= lambda_n  _|_  v_n + gap / h >= 0          v_n = v_y + omega r_x + u_y
//   friction |lambda_t| <= mu lambda_n, opposing v_t         v_t = v_x - omega r_y + u_x
// u is the endpoint's velocity by the changing shape alone. gap / h lets an endpoint reach the ground within
// this step and no further, so nothing ever bounces.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/numeric/lane.h"
#include "core/physics/constants.h"

namespace gaitsmith {

template <int W>
struct Contact {
  using F = typename Lane<W>::F;
  using I = typename Lane<W>::I;
  F arm_x, arm_y;         // from the centre of mass, world frame, at mid-step [m]
  F drift_x, drift_y;     // u [m/s]
  F reach;                // gap / h, >= 0 [m/s]
  I near_ground;          // lanes in which this endpoint takes part
  F normal{}, tangent{};  // accumulated impulses [N s]
  F slide{}, approach{};  // v_t and v_n after the solution [m/s]
  std::size_t endpoint = 0;
};

template <int W>
struct RigidMotion {
  using F = typename Lane<W>::F;
  F velocity_x, velocity_y;  // of the centre of mass [m/s]
  F spin;                    // of the root frame [rad/s]
};

/// Velocity of an endpoint by a unit impulse there: a symmetric 2 x 2 matrix, normal (n) and tangent (t).
template <int W>
struct Mobility {
  using F = typename Lane<W>::F;
  F nn, nt, tt;              // [1/kg]
  F inverse_determinant;     // of the above [kg^2]; > 0
  F spin_per_n, spin_per_t;  // spin of the figure by a unit impulse [1/(kg m)]
};

template <int W>
struct Impulse {
  using F = typename Lane<W>::F;
  F normal, tangent;  // [N s]
};

/// The impulse that alone satisfies contact and friction at one endpoint, exactly: nothing for an endpoint
/// that would not reach the ground; stick (both velocities vanish) if that lies in the friction cone; else
/// slip on the edge of the cone, to the side on which friction opposes it. One of the three always fits;
/// where rounding denies all of them, at the very edge of the cone, the edge next to sticking is taken.
/// @param b_n, b_t velocities without this impulse (v_n with gap / h added) [m/s]
template <int W>
Impulse<W> SolveOne(const Mobility<W>& m, typename Lane<W>::F b_n, typename Lane<W>::F b_t, float friction) {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;
  const F stick_n = (m.nt * b_t - m.tt * b_n) * m.inverse_determinant;
  const F stick_t = (m.nt * b_n - m.nn * b_t) * m.inverse_determinant;
  const I sticks = (stick_n > 0.0f) & (L::Abs(stick_t) <= friction * stick_n);

  // Friction +mu lambda_n pushes right, so the endpoint must slide left, and the other way round.
  const F right_by = m.nn + friction * m.nt;
  const F left_by = m.nn - friction * m.nt;
  const F right_n = -b_n / right_by;
  const F left_n = -b_n / left_by;
  const I right = (right_by > 0.0f) & (b_t + (m.nt + friction * m.tt) * right_n <= 0.0f);
  const I left = (left_by > 0.0f) & (b_t + (m.nt - friction * m.tt) * left_n >= 0.0f);

  Impulse<W> impulse;
  const I rightward = right | (~left & (stick_t > 0.0f) & (right_by > 0.0f));
  const I leftward = ~rightward & (left_by > 0.0f);
  const F edge_n = L::Select(rightward, right_n, L::Select(leftward, left_n, -b_n / m.nn));
  const F edge_t = L::Select(rightward, friction * right_n, L::Select(leftward, -(friction * left_n), F{}));
  impulse.normal = L::Select(sticks, stick_n, edge_n);
  impulse.tangent = L::Select(sticks, stick_t, edge_t);
  const I apart = ~(b_n < 0.0f);
  impulse.normal = L::Select(apart, F{}, impulse.normal);
  impulse.tangent = L::Select(apart, F{}, impulse.tangent);
  return impulse;
}

/// Solves all contacts of one step, starting from the impulses they carry. Sweeps go forward and backward in
/// turn, so that neither end of a figure is favoured. A lane that a sweep has hardly moved is settled and
/// left alone from then on: what it gets depends on nothing but itself.
/// @param inverse_inertia about the centre of mass [1/(kg m^2)]
/// @param motion          without the contacts' impulses; with them afterwards
template <int W>
void SolveContacts(std::span<Contact<W>> contacts, float inverse_mass, typename Lane<W>::F inverse_inertia,
                   float friction, RigidMotion<W>& motion) {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;
  std::array<Mobility<W>, kMaxEndpoints> mobilities;
  const auto apply = [&](const Mobility<W>& m, F push_n, F push_t) {
    motion.velocity_x += push_t * inverse_mass;
    motion.velocity_y += push_n * inverse_mass;
    motion.spin += push_n * m.spin_per_n + push_t * m.spin_per_t;
  };
  const auto approach = [&](const Contact<W>& c) {
    return motion.velocity_y + motion.spin * c.arm_x + c.drift_y;
  };
  const auto slide = [&](const Contact<W>& c) {
    return motion.velocity_x - motion.spin * c.arm_y + c.drift_x;
  };

  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact<W>& c = contacts[i];
    Mobility<W>& m = mobilities[i];
    m.spin_per_n = c.arm_x * inverse_inertia;
    m.spin_per_t = -c.arm_y * inverse_inertia;
    m.nn = inverse_mass + c.arm_x * m.spin_per_n;
    m.nt = c.arm_x * m.spin_per_t;
    m.tt = inverse_mass - c.arm_y * m.spin_per_t;
    // nn tt - nt^2, in the form that cannot cancel.
    m.inverse_determinant =
        1.0f / (inverse_mass * (inverse_mass + (c.arm_x * c.arm_x + c.arm_y * c.arm_y) * inverse_inertia));
    apply(m, c.normal, c.tangent);
  }
  I settled{};
  for (int sweep = 0; sweep < kContactSweeps; ++sweep) {
    F moved{};
    for (std::size_t turn = 0; turn < contacts.size(); ++turn) {
      const std::size_t i = sweep % 2 == 0 ? turn : contacts.size() - 1 - turn;
      Contact<W>& c = contacts[i];
      const Mobility<W>& m = mobilities[i];
      const F b_n = approach(c) + c.reach - (m.nn * c.normal + m.nt * c.tangent);
      const F b_t = slide(c) - (m.nt * c.normal + m.tt * c.tangent);
      const Impulse<W> impulse = SolveOne<W>(m, b_n, b_t, friction);
      const I takes_part = c.near_ground & ~settled;
      const F push_n = L::Select(takes_part, impulse.normal - c.normal, F{});
      const F push_t = L::Select(takes_part, impulse.tangent - c.tangent, F{});
      c.normal = L::Select(takes_part, impulse.normal, c.normal);
      c.tangent = L::Select(takes_part, impulse.tangent, c.tangent);
      apply(m, push_n, push_t);
      moved += L::Abs(push_n) + L::Abs(push_t);
    }
    settled |= moved * inverse_mass <= kContactTolerance;
    if (!L::Any(~settled)) break;
  }
  for (Contact<W>& c : contacts) {
    c.approach = approach(c);
    c.slide = slide(c);
  }
}

}  // namespace gaitsmith
