// SPDX-License-Identifier: MIT
// Where the points of a figure with moving limbs are, and how its speeds move them (model 2).
#pragma once

#include <array>

#include "core/numeric/scalar_math.h"
#include "core/physics/limb_inertia.h"
#include "core/physics/limb_state.h"

namespace gaitsmith {

/// Where the endpoints are at one instant, and how each speed moves them.
template <int W>
struct LimbArms {
  using F = typename Lane<W>::F;
  using I = typename Lane<W>::I;
  std::array<F, kMaxEndpoints> x, y;  // endpoints from the centre of mass [m]
  LimbNumbers<W> pull_x, pull_y;      // how the centre of mass moves with a joint, seen from it [m]

  LimbArms(const Mechanism& body, const LimbNumbers<W>& cosine, const LimbNumbers<W>& sine) {
    const auto n = static_cast<std::size_t>(body.rods);
    x[0] = y[0] = F{};
    F centre_x{}, centre_y{};
    for (std::size_t a = 0; a < n; ++a) {
      const auto start = static_cast<std::size_t>(body.limbs[a].start);
      x[a + 1] = x[start] + body.limbs[a].length_m * cosine[a];
      y[a + 1] = y[start] + body.limbs[a].length_m * sine[a];
      pull_x[a] = body.centre[a] * cosine[a];
      pull_y[a] = body.centre[a] * sine[a];
      centre_x += pull_x[a];
      centre_y += pull_y[a];
    }
    for (std::size_t k = 0; k <= n; ++k) {
      x[k] -= centre_x;
      y[k] -= centre_y;
    }
    SumBeyond<W>(body, pull_x);
    SumBeyond<W>(body, pull_y);
  }

  /// The velocity of an endpoint by unit speeds, upwards (n) and along the ground (t) [m].
  void RowsOf(const Mechanism& body, std::size_t endpoint, LimbNumbers<W>& n, LimbNumbers<W>& t) const {
    n[0] = x[endpoint];
    t[0] = -y[endpoint];
    for (std::size_t j = 1; j < static_cast<std::size_t>(body.rods); ++j) {
      n[j] = -pull_x[j];
      t[j] = pull_y[j];
      if ((body.beyond[j] >> endpoint & 1) == 0) continue;
      const auto pivot = static_cast<std::size_t>(body.limbs[j].start);
      n[j] += x[endpoint] - x[pivot];
      t[j] -= y[endpoint] - y[pivot];
    }
  }

  /// The same for a point on a rod, in each lane another one.
  /// @param tip  bit of the endpoint at the rod's outer end
  /// @param px, py  the point from the centre of mass [m]
  void RowsOf(const Mechanism& body, const I& tip, const F& px, const F& py, LimbNumbers<W>& n,
              LimbNumbers<W>& t) const {
    n[0] = px;
    t[0] = -py;
    for (std::size_t j = 1; j < static_cast<std::size_t>(body.rods); ++j) {
      const auto pivot = static_cast<std::size_t>(body.limbs[j].start);
      const I moves = (tip & body.beyond[j]) != 0;
      n[j] = Lane<W>::Select(moves, px - x[pivot], F{}) - pull_x[j];
      t[j] = pull_y[j] - Lane<W>::Select(moves, py - y[pivot], F{});
    }
  }
};

/// Directions of the rods and places of the endpoints, from the angles. Computed afresh in each step, so
/// that errors do not add up.
template <int W>
void PlaceLimbs(const Mechanism& body, LimbState<W>& s) {
  SinCosOfTurn<W>(s.turn_rad, s.sine[0], s.cosine[0]);
  for (std::size_t a = 1; a < static_cast<std::size_t>(body.rods); ++a) {
    const Skeleton::Limb& limb = body.limbs[a];
    const auto parent = static_cast<std::size_t>(limb.parent);
    typename Lane<W>::F sine, cosine;
    SinCos<W>(s.angle_rad[a - 1] + limb.rest_rad, sine, cosine);
    s.cosine[a] = s.cosine[parent] * cosine - s.sine[parent] * sine;
    s.sine[a] = s.sine[parent] * cosine + s.cosine[parent] * sine;
  }
  const LimbArms<W> arms(body, s.cosine, s.sine);
  s.endpoint_x = arms.x;
  s.endpoint_y = arms.y;
}

}  // namespace gaitsmith
