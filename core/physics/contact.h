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

/// Solves all contacts of one step. Sweeps go forward and backward in turn, so that neither end of a figure
/// is favoured; they start from zero impulse and stop when one changes nothing in any lane (further ones
/// would not either).
/// @param inverse_inertia about the centre of mass [1/(kg m^2)]
template <int W>
void SolveContacts(std::span<Contact<W>> contacts, float inverse_mass, typename Lane<W>::F inverse_inertia,
                   float friction, RigidMotion<W>& motion) {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;
  struct Response {  // of the endpoint's velocity to an impulse there; zero in lanes that take no part
    F normal_mass, tangent_mass, spin_per_normal, spin_per_tangent;
  };
  std::array<Response, kMaxEndpoints> responses;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact<W>& c = contacts[i];
    Response& r = responses[i];
    r.spin_per_normal = c.arm_x * inverse_inertia;
    r.spin_per_tangent = -c.arm_y * inverse_inertia;
    r.normal_mass = L::Select(c.near_ground, 1.0f / (inverse_mass + c.arm_x * r.spin_per_normal), F{});
    r.tangent_mass = L::Select(c.near_ground, 1.0f / (inverse_mass - c.arm_y * r.spin_per_tangent), F{});
  }

  for (int sweep = 0; sweep < kContactSweeps; ++sweep) {
    I changed{};
    for (std::size_t turn = 0; turn < contacts.size(); ++turn) {
      const std::size_t i = sweep % 2 == 0 ? turn : contacts.size() - 1 - turn;
      Contact<W>& c = contacts[i];
      const Response& r = responses[i];

      const F v_n = motion.velocity_y + motion.spin * c.arm_x + c.drift_y;
      const F normal = L::Max(c.normal - r.normal_mass * (v_n + c.reach), F{});
      const F push_n = normal - c.normal;
      c.normal = normal;
      motion.velocity_y += push_n * inverse_mass;
      motion.spin += push_n * r.spin_per_normal;

      const F v_t = motion.velocity_x - motion.spin * c.arm_y + c.drift_x;
      const F limit = friction * c.normal;
      const F tangent = L::Max(L::Min(c.tangent - r.tangent_mass * v_t, limit), -limit);
      const F push_t = tangent - c.tangent;
      c.tangent = tangent;
      motion.velocity_x += push_t * inverse_mass;
      motion.spin += push_t * r.spin_per_tangent;

      changed |= (push_n != 0.0f) | (push_t != 0.0f);
    }
    if (!L::Any(changed)) break;
  }
  for (Contact<W>& c : contacts) {
    c.approach = motion.velocity_y + motion.spin * c.arm_x + c.drift_y;
    c.slide = motion.velocity_x - motion.spin * c.arm_y + c.drift_x;
  }
}

}  // namespace gaitsmith
