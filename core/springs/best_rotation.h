// SPDX-License-Identifier: MIT
// How far a figure of springs has turned.
#pragma once

#include "core/numeric/scalar_math.h"
#include "core/springs/lattice.h"
#include "core/springs/lattice_state.h"

namespace gaitsmith {

/// A figure whose nodes have come together to less than this share of its drawn moment of inertia keeps its
/// turn.
inline constexpr float kLeastSpread = 1e-6f;

/// The rotation of the drawn pose that fits the nodes best, by least squares with their masses as weights
/// [Kabsch 1976].
template <int W>
void MeasureTurn(const Lattice& body, LatticeState<W>& s) {
  using L = Lane<W>;
  using F = typename L::F;
  F along{}, across{};
  for (std::size_t k = 0; k < body.nodes; ++k) {
    const float x = body.mass_kg[k] * body.drawn_x[k], y = body.mass_kg[k] * body.drawn_y[k];
    const F up = s.y[k];
    along += x * s.x[k] + y * up;
    across += x * up - y * s.x[k];
  }
  const F norm = L::Sqrt(along * along + across * across);
  const typename L::I known = norm > kLeastSpread * body.drawn_kgm2;
  const F inverse = 1.0f / L::Select(known, norm, L::Splat(1.0f));
  s.cosine = L::Select(known, along * inverse, s.cosine);
  s.sine = L::Select(known, across * inverse, s.sine);
  constexpr double kRound = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds to the nearest integer
  for (int lane = 0; lane < W; ++lane) {
    const double angle = static_cast<double>(Atan2(s.sine[lane], s.cosine[lane]));
    const double turns = ((s.turn_rad[lane] - angle) * (0.5 / kPi) + kRound) - kRound;
    s.turn_rad[lane] = angle + turns * (2.0 * kPi);
  }
}

}  // namespace gaitsmith
