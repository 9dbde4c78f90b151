// SPDX-License-Identifier: MIT
// Contact of endpoints with the ground: inelastic, with Coulomb friction and without penetration. Each step
// is one complementarity problem on velocities [Stewart Trinkle 1996]. This file solves it exactly for one
// and two endpoints. contact_sweeps.h solves it for more.
//
// At one instant a figure is one rigid body: centre of mass at height H, velocity (v_x, v_y), spin omega. The
// ground is flat, so all its forces act at height 0. For an endpoint that touches at x from the centre of
// mass, and that the changing shape alone moves with velocity u,
//   normal    0 <= lambda  _|_  v_n >= 0         v_n = v_y + omega x + u_y + gap / h
//   friction  |T| <= mu lambda, opposing v_t     v_t = v_x + omega H + u_x
// The term gap / h lets an endpoint reach the ground within this step and no further, so nothing ever
// bounces.
#pragma once

#include "core/numeric/lane.h"
#include "core/physics/constants.h"
#include "core/physics/world.h"

namespace gaitsmith {

/// The ground's impulse on one endpoint.
template <int W>
struct Impulse {
  typename Lane<W>::F normal, tangent;  // [N s]
};

/// W figures at one instant, each as one rigid body that moves as it would without the ground.
template <int W>
struct Body {
  using F = typename Lane<W>::F;
  F velocity_x, velocity_y;  // of the centre of mass [m/s]
  F spin;                    // of the root frame [rad/s]
  F height;                  // H [m]
  F inertia;                 // about the centre of mass [kg m^2]
  F inverse_inertia;

  void Push(const World& world, F arm, const Impulse<W>& force) {
    velocity_x += force.tangent * world.inverse_mass;
    velocity_y += force.normal * world.inverse_mass;
    spin += (force.normal * arm + force.tangent * height) * inverse_inertia;
  }
};

template <int W>
struct Contact {
  using F = typename Lane<W>::F;
  F arm;             // x from the centre of mass, at mid-step [m]
  F drift_t;         // u_x [m/s]
  F drift_n;         // u_y + gap / h [m/s]
  Impulse<W> force;  // impulse by the ground

  [[nodiscard]] F Approach(const Body<W>& body) const { return body.velocity_y + body.spin * arm + drift_n; }
  [[nodiscard]] F Slide(const Body<W>& body) const {
    return body.velocity_x + body.spin * body.height + drift_t;
  }
};

/// The velocity that a unit impulse at an endpoint gives this endpoint: a symmetric 2 x 2 matrix, normal (n)
/// and tangent (t).
template <int W>
struct Mobility {
  using F = typename Lane<W>::F;
  F nn, nt, tt;               // [1/kg]
  F inverse_determinant;      // of the matrix above [kg^2], > 0
  F right_per_n, left_per_n;  // stops an approach of 1 m/s while friction pushes right or left [kg]

  Mobility() = default;
  Mobility(const World& world, const Body<W>& body, F arm) {
    const F turned = arm * body.inverse_inertia;
    const F raised = body.height * body.inverse_inertia;
    nn = world.inverse_mass + arm * turned;
    nt = body.height * turned;
    tt = world.inverse_mass + body.height * raised;
    // nn tt - nt^2, in a form without cancellation.
    inverse_determinant =
        1.0f / (world.inverse_mass * (world.inverse_mass + (arm * turned + body.height * raised)));
    right_per_n = 1.0f / (nn + world.friction * nt);
    left_per_n = 1.0f / (nn - world.friction * nt);
  }
};

/// The impulse that stops an endpoint in both directions.
template <int W>
Impulse<W> Stop(const Mobility<W>& m, typename Lane<W>::F b_n, typename Lane<W>::F b_t) {
  return {(m.nt * b_t - m.tt * b_n) * m.inverse_determinant,
          (m.nt * b_n - m.nn * b_t) * m.inverse_determinant};
}

/// Lanes in which an impulse pushes away from the ground and lies in the friction cone.
template <int W>
typename Lane<W>::I InCone(const Impulse<W>& force, float friction) {
  return (force.normal > 0.0f) & (Lane<W>::Abs(force.tangent) <= friction * force.normal);
}

/// The impulse that alone satisfies contact and friction at one endpoint, exactly:
/// - none for an endpoint that would not reach the ground
/// - stick (both velocities vanish) if that impulse lies in the friction cone
/// - else slip on the edge of the cone, to the side on which friction opposes the slip
///
/// One of the three always fits. If rounding rejects all of them, at the very edge of the cone, the edge next
/// to sticking is taken. In exact arithmetic the sign of stop's tangent alone decides between right and left.
/// In floats this sign is noise when a figure's radius of gyration is tiny against the arm, and the ground
/// would pull. That is why all the conditions are checked.
/// @param b_n, b_t v_n and v_t without this impulse [m/s]
template <int W>
Impulse<W> SolveOne(const Mobility<W>& m, typename Lane<W>::F b_n, typename Lane<W>::F b_t, float friction) {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;
  const Impulse<W> stop = Stop<W>(m, b_n, b_t);
  const I sticks = InCone<W>(stop, friction);

  // Friction +mu lambda pushes right, so the endpoint must slide left. The mirror case is the same.
  const F right_n = -b_n * m.right_per_n;
  const F left_n = -b_n * m.left_per_n;
  const I can_right = m.right_per_n > 0.0f, can_left = m.left_per_n > 0.0f;
  const I right = can_right & (b_t + (m.nt + friction * m.tt) * right_n <= 0.0f);
  const I left = can_left & (b_t + (m.nt - friction * m.tt) * left_n >= 0.0f);
  const I rightward = right | (~left & can_right & ((stop.tangent > 0.0f) | ~can_left));

  const F edge_n = L::Select(rightward, right_n, left_n);
  const F edge_t = friction * L::Select(rightward, right_n, -left_n);
  const I meets = b_n < 0.0f;
  return {L::Select(meets, L::Select(sticks, stop.normal, edge_n), F{}),
          L::Select(meets, L::Select(sticks, stop.tangent, edge_t), F{})};
}

/// The impulses of two endpoints that both stay on the ground, exactly. Two points determine how the figure
/// moves up and how it spins. So the sum N of the normal impulses and the total moment of normal impulses and
/// friction are known. Unknown is the sum T of the friction impulses, and both slides depend on T in the same
/// way. Let `low` be the endpoint that drifts further left, and `high` the other. There are five modes:
///   T = -mu N                     both slip right
///   T = T_low, which stops low    high slips right
///   T = mu (low_n - high_n)       low slips left, high right
///   T = T_high, which stops high  low slips left
///   T = mu N                      both slip left
/// The friction's moment loads one of the two. If they drift apart on a narrow stance, either can stick. Then
/// the smaller |T| is taken, so that the endpoint that sticks continues to stick.
/// @return the lanes in which this is the solution: both impulses push, and the endpoints are far enough
/// apart
template <int W>
typename Lane<W>::I SolveBoth(const World& world, const Body<W>& body, Contact<W>& one, Contact<W>& two) {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;
  const I swap = one.drift_t > two.drift_t;
  const F low_arm = L::Select(swap, two.arm, one.arm), high_arm = L::Select(swap, one.arm, two.arm);
  const F low_drift = L::Min(two.drift_t, one.drift_t), high_drift = L::Max(one.drift_t, two.drift_t);

  const F inverse_stance = 1.0f / (two.arm - one.arm);
  const F spin = (one.drift_n - two.drift_n) * inverse_stance;
  const F velocity_y = -one.drift_n - spin * one.arm;
  const F sum_n = (velocity_y - body.velocity_y) * world.mass_kg;  // N
  const F moment = (spin - body.spin) * body.inertia;              // of normal impulses and friction
  const F slide = body.velocity_x + spin * body.height;            // without friction and drift
  const F low_stop = -world.mass_kg * (slide + low_drift);         // T_low
  const F high_stop = -world.mass_kg * (slide + high_drift);       // T_high <= T_low

  // mu (low_n - high_n) as a function of T: apart_0 + apart_1 T.
  const F inverse_width = L::Select(swap, -inverse_stance, inverse_stance);  // 1 / (high_arm - low_arm)
  const F scale = world.friction * inverse_width;
  const F apart_0 = ((low_arm + high_arm) * sum_n - 2.0f * moment) * scale;
  const F apart_1 = 2.0f * body.height * scale;
  const F most = world.friction * sum_n;
  const F low_t = L::Max(-most, L::Min(most, low_stop)), high_t = L::Max(-most, L::Min(most, high_stop));
  const F low_apart = apart_0 + apart_1 * low_t, high_apart = apart_0 + apart_1 * high_t;
  const I low_can = (low_apart >= low_t) & (L::Abs(low_apart) <= most);
  const I high_can = (high_apart <= high_t) & (L::Abs(high_apart) <= most);
  const I low_sticks = low_can & (~high_can | (L::Abs(low_t) < L::Abs(high_t)));
  const F apart_t = apart_0 / (1.0f - apart_1);
  const I fits = low_can | high_can | ((apart_t >= high_stop) & (apart_t <= low_stop));
  const F sum_t = L::Select(low_sticks, low_t, L::Select(high_can, high_t, apart_t));

  const F normal_moment = moment - sum_t * body.height;
  const F low_n = (high_arm * sum_n - normal_moment) * inverse_width;
  const F high_n = (normal_moment - low_arm * sum_n) * inverse_width;
  const F low_most = world.friction * low_n, high_most = world.friction * high_n;
  const F low_share = L::Max(-low_most, L::Min(low_most, sum_t + high_most));
  const F high_share = L::Max(-high_most, L::Min(high_most, sum_t - low_share));
  one.force = {L::Select(swap, high_n, low_n), L::Select(swap, high_share, low_share)};
  two.force = {L::Select(swap, low_n, high_n), L::Select(swap, low_share, high_share)};
  return fits & (low_n >= 0.0f) & (high_n >= 0.0f) & (L::Abs(two.arm - one.arm) > kMinStance);
}

/// Solves one endpoint alone.
template <int W>
void SolveSingle(const World& world, const Body<W>& body, Contact<W>& contact) {
  const Mobility<W> mobility(world, body, contact.arm);
  contact.force = SolveOne<W>(mobility, contact.Approach(body), contact.Slide(body), world.friction);
}

/// Solves two endpoints: both together if both impulses push, else one alone if its impulse keeps the other
/// from the ground. There is one more case: friction can jam an endpoint that would not even approach. This
/// solution is used only if no other fits.
/// @param has_two lanes that have a second contact. The other lanes are solved as SolveSingle does, with the
/// same bits.
template <int W>
void SolvePair(const World& world, const Body<W>& body, Contact<W>& one, Contact<W>& two,
               const typename Lane<W>::I& has_two) {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;
  I open = ~(SolveBoth<W>(world, body, one, two) & has_two);
  if (!L::Any(open)) return;
  const Impulse<W> nothing = {F{}, F{}};
  const auto offer = [&](const Impulse<W>& for_one, const Impulse<W>& for_two, I fits) {
    const I taken = open & fits;
    one.force = {L::Select(taken, for_one.normal, one.force.normal),
                 L::Select(taken, for_one.tangent, one.force.tangent)};
    two.force = {L::Select(taken, for_two.normal, two.force.normal),
                 L::Select(taken, for_two.tangent, two.force.tangent)};
    open &= ~fits;
  };
  const Mobility<W> m_one(world, body, one.arm);
  const Impulse<W> alone_one = SolveOne<W>(m_one, one.Approach(body), one.Slide(body), world.friction);
  // Lanes without a second contact are done. At high speed even the placeholder that is out of reach would
  // reach the ground, so they must not check where it would go.
  offer(alone_one, nothing, ~has_two);
  if (!L::Any(open)) return;
  const auto approach_after = [&](const Contact<W>& other, F arm, const Impulse<W>& force) {
    Body<W> then = body;
    then.Push(world, arm, force);
    return other.Approach(then);
  };
  const Mobility<W> m_two(world, body, two.arm);
  const Impulse<W> alone_two = SolveOne<W>(m_two, two.Approach(body), two.Slide(body), world.friction);
  const F two_then = approach_after(two, one.arm, alone_one);
  const F one_then = approach_after(one, two.arm, alone_two);
  offer(alone_one, nothing, two_then >= -kContactTolerance);
  offer(nothing, alone_two, one_then >= -kContactTolerance);
  if (!L::Any(open)) return;
  const Impulse<W> jam_one = Stop<W>(m_one, one.Approach(body), one.Slide(body));
  const Impulse<W> jam_two = Stop<W>(m_two, two.Approach(body), two.Slide(body));
  offer(jam_one, nothing,
        InCone<W>(jam_one, world.friction) & (approach_after(two, one.arm, jam_one) >= -kContactTolerance));
  offer(nothing, jam_two,
        InCone<W>(jam_two, world.friction) & (approach_after(one, two.arm, jam_two) >= -kContactTolerance));
  // Rounding rejects every solution: take the one with the smaller error.
  offer(alone_one, nothing, two_then >= one_then);
  offer(nothing, alone_two, ~I{});
}

}  // namespace gaitsmith
