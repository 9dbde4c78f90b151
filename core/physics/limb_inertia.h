// SPDX-License-Identifier: MIT
// The equations of motion of W figures with moving limbs, at one instant. Unknown are the speeds of the root
// (index 0) and of each joint (by its outer limb). The linear part, the centre of mass, is solved separately.
#pragma once

#include <array>

#include "core/numeric/lane.h"
#include "core/physics/mechanism.h"

namespace gaitsmith {

template <int W>
using LimbNumbers = std::array<typename Lane<W>::F, kMaxRods>;

/// Mass matrix and bias at one instant.
template <int W>
struct LimbInertia {
  using F = typename Lane<W>::F;
  /// M, lower triangle [kg m^2]: the momentum beyond joint j is sum_k M_jk speed_k.
  std::array<LimbNumbers<W>, kMaxRods> mass;
  /// Change of that momentum by the limbs' own motion [N m]. 0 for the root: internal forces do not turn a
  /// figure as a whole.
  LimbNumbers<W> bias;

  /// Momenta of these speeds [kg m^2/s].
  [[nodiscard]] LimbNumbers<W> Momenta(std::size_t n, const LimbNumbers<W>& speed) const {
    LimbNumbers<W> sum;
    for (std::size_t j = 0; j < n; ++j) {
      F all{};
      for (std::size_t k = 0; k < n; ++k) all += (k <= j ? mass[j][k] : mass[k][j]) * speed[k];
      sum[j] = all;
    }
    return sum;
  }
};

/// Sums over the limbs beyond each joint, in place.
template <int W>
void SumBeyond(const Mechanism& body, LimbNumbers<W>& numbers) {
  for (std::size_t a = static_cast<std::size_t>(body.rods); a-- > 1;)
    numbers[static_cast<std::size_t>(body.limbs[a].parent)] += numbers[a];
}

/// How fast each rod turns [rad/s], given the speeds of the root and the joints.
template <int W>
LimbNumbers<W> TurningOf(const Mechanism& body, const LimbNumbers<W>& speed) {
  LimbNumbers<W> turning;
  for (std::size_t a = 0; a < static_cast<std::size_t>(body.rods); ++a) {
    turning[a] = speed[a];
    if (a > 0) turning[a] += turning[static_cast<std::size_t>(body.limbs[a].parent)];
  }
  return turning;
}

/// Measures M. @param cosine, sine of the rods' directions
template <int W>
void MeasureMass(const Mechanism& body, const LimbNumbers<W>& cosine, const LimbNumbers<W>& sine,
                 LimbInertia<W>& out) {
  const auto n = static_cast<std::size_t>(body.rods);
  std::array<LimbNumbers<W>, kMaxRods> rows;  // between rods, then sums over the rods beyond each joint
  for (std::size_t a = 0; a < n; ++a) {
    rows[a][a] = Lane<W>::Splat(body.coupling[a][a]);
    for (std::size_t b = 0; b < a; ++b)
      rows[a][b] = rows[b][a] = body.coupling[a][b] * (cosine[a] * cosine[b] + sine[a] * sine[b]);
  }
  for (std::size_t a = n; a-- > 1;) {
    const auto parent = static_cast<std::size_t>(body.limbs[a].parent);
    for (std::size_t b = 0; b < n; ++b) rows[parent][b] += rows[a][b];
  }
  for (std::size_t j = 0; j < n; ++j) {
    SumBeyond<W>(body, rows[j]);
    for (std::size_t k = 0; k <= j; ++k) out.mass[j][k] = rows[j][k];
  }
}

/// Measures the bias. @param turning of each rod [rad/s]
template <int W>
void MeasureBias(const Mechanism& body, const LimbNumbers<W>& cosine, const LimbNumbers<W>& sine,
                 const LimbNumbers<W>& turning, LimbInertia<W>& out) {
  using F = typename Lane<W>::F;
  const auto n = static_cast<std::size_t>(body.rods);
  for (std::size_t a = 0; a < n; ++a) {
    out.bias[a] = F{};
    for (std::size_t b = 0; b < a; ++b) {
      const F turned = sine[a] * cosine[b] - cosine[a] * sine[b];
      const F pull = body.coupling[a][b] * turned * (turning[a] * turning[b]);
      out.bias[a] -= pull;
      out.bias[b] += pull;
    }
  }
  SumBeyond<W>(body, out.bias);
  out.bias[0] = F{};
}

/// M plus a diagonal, factored from the leaves to the root, so that even joints a million times firmer than
/// their limbs are heavy cost no accuracy: L^T D L.
template <int W>
class LimbFactor {
  using F = typename Lane<W>::F;

 public:
  LimbFactor(std::size_t n, const LimbInertia<W>& inertia, const LimbNumbers<W>& firmness) : n_(n) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j <= i; ++j) rows_[i][j] = inertia.mass[i][j];
      rows_[i][i] += firmness[i];
    }
    for (std::size_t i = n; i-- > 0;) {
      inverse_[i] = 1.0f / rows_[i][i];
      for (std::size_t j = 0; j < i; ++j) {
        const F share = rows_[i][j] * inverse_[i];
        for (std::size_t k = 0; k <= j; ++k) rows_[j][k] -= share * rows_[i][k];
      }
    }
  }

  /// Replaces momenta by speeds.
  void Solve(LimbNumbers<W>& numbers) const {
    SolveInward(numbers);
    SolveOutward(numbers);
  }
  /// The first half of that: what the limbs pass on to the root.
  void SolveInward(LimbNumbers<W>& numbers) const {
    for (std::size_t i = n_; i-- > 0;) {
      const F share = numbers[i] * inverse_[i];
      for (std::size_t j = 0; j < i; ++j) numbers[j] -= rows_[i][j] * share;
    }
  }
  /// The second half: how the limbs answer.
  void SolveOutward(LimbNumbers<W>& numbers) const {
    for (std::size_t i = 0; i < n_; ++i) {
      F left = numbers[i];
      for (std::size_t j = 0; j < i; ++j) left -= rows_[i][j] * numbers[j];
      numbers[i] = left * inverse_[i];
    }
  }
  /// What momenta a, turned into speeds, do along b; both solved inward.
  F Between(const LimbNumbers<W>& a, const LimbNumbers<W>& b) const {
    F sum{};
    for (std::size_t i = 0; i < n_; ++i) sum += a[i] * inverse_[i] * b[i];
    return sum;
  }

 private:
  std::size_t n_;
  std::array<LimbNumbers<W>, kMaxRods> rows_;
  LimbNumbers<W> inverse_;
};

}  // namespace gaitsmith
