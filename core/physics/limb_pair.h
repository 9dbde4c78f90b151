// SPDX-License-Identifier: MIT
// Two endpoints of a figure with moving limbs on the ground, solved exactly (model 2).
#pragma once

#include <array>

#include "core/physics/contact.h"

namespace gaitsmith {

/// How a unit impulse on one endpoint moves another: normal (n) and tangent (t) [1/kg].
template <int W>
struct Coupling {
  typename Lane<W>::F nn, nt, tn, tt;
};

/// The answer of an endpoint to its own impulse, as one contact is solved with it.
template <int W>
Mobility<W> MobilityOf(const Coupling<W>& own, float friction) {
  Mobility<W> m;
  m.nn = own.nn;
  m.nt = own.nt;
  m.tt = own.tt;
  m.inverse_determinant = 1.0f / (own.nn * own.tt - own.nt * own.nt);
  m.right_per_n = 1.0f / (own.nn + friction * own.nt);
  m.left_per_n = 1.0f / (own.nn - friction * own.nt);
  return m;
}

/// Two contacts of each lane.
template <int W>
class LimbPair {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;

 public:
  explicit LimbPair(float friction) : friction_(friction) {}

  std::array<std::array<Coupling<W>, 2>, 2> mobility{};
  std::array<F, 2> free_n{}, free_t{};  // velocities without the two impulses [m/s]
  std::array<Impulse<W>, 2> before{};   // when contacts were last solved

  /// Finds the impulses that satisfy contact and friction at both endpoints. There may be several solutions
  /// (Painleve's paradox). What the endpoints did before goes first. Then the same order applies as in model
  /// 1: both bear before one bears alone, both stick before one slips, and of the others the least friction
  /// is taken.
  /// @return the lanes that have a solution
  I Solve(const I& lanes, std::array<Impulse<W>, 2>& force) const {
    I open = lanes;
    GoOn(open, force);
    if (L::Any(open)) open &= ~Try(kStick, kStick, open, force);
    if (L::Any(open)) BearBoth(open, force);
    for (std::size_t i = 0; i < 2 && L::Any(open); ++i) open &= ~BearAlone(i, open, force);
    return lanes & ~open;
  }

 private:
  /// Lanes in which friction pushes right, or left; in the others the endpoint sticks.
  struct Friction {
    I right{}, left{};
  };
  static constexpr Friction kStick{}, kRight{~I{}, I{}}, kLeft{I{}, ~I{}};

  static void Put(const I& lanes, const std::array<Impulse<W>, 2>& from, std::array<Impulse<W>, 2>& to) {
    for (std::size_t i = 0; i < 2; ++i) {
      to[i] = {L::Select(lanes, from[i].normal, to[i].normal),
               L::Select(lanes, from[i].tangent, to[i].tangent)};
    }
  }

  /// Lets the endpoints do what they did before, where that is a solution.
  void GoOn(I& open, std::array<Impulse<W>, 2>& force) const {
    std::array<I, 2> bore;
    std::array<Friction, 2> friction;
    for (std::size_t i = 0; i < 2; ++i) {
      const F most = friction_ * before[i].normal;
      bore[i] = before[i].normal > 0.0f;
      friction[i] = {before[i].tangent >= most, before[i].tangent <= -most};
    }
    const I both = open & bore[0] & bore[1];
    if (L::Any(both)) open &= ~Try(friction[0], friction[1], both, force);
    for (std::size_t i = 0; i < 2; ++i) {
      const I alone = open & bore[i] & ~bore[1 - i];
      if (L::Any(alone)) open &= ~BearAlone(i, alone, force);
    }
  }

  /// Lets one or both endpoints slip, with the least friction.
  void BearBoth(I& open, std::array<Impulse<W>, 2>& force) const {
    I found{};
    std::array<Impulse<W>, 2> best{};
    F least{};
    const auto offer = [&](const Friction& one, const Friction& two) {
      std::array<Impulse<W>, 2> candidate{};
      const I fits = Try(one, two, open, candidate);
      const F sum = L::Abs(candidate[0].tangent + candidate[1].tangent);
      const I better = fits & (~found | (sum < least));
      least = L::Select(better, sum, least);
      Put(better, candidate, best);
      found |= fits;
    };
    offer(kStick, kRight);
    offer(kStick, kLeft);
    offer(kRight, kStick);
    offer(kLeft, kStick);
    Put(found, best, force);
    open &= ~found;
    if (!L::Any(open)) return;
    offer(kRight, kRight);
    offer(kLeft, kLeft);
    offer(kRight, kLeft);
    offer(kLeft, kRight);
    Put(found & open, best, force);
    open &= ~found;
  }

  /// Lets one endpoint bear, if that keeps the other from the ground. @return the lanes in which it does
  I BearAlone(std::size_t endpoint, const I& lanes, std::array<Impulse<W>, 2>& force) const {
    std::array<Impulse<W>, 2> alone{};
    alone[endpoint] = SolveOne<W>(MobilityOf<W>(mobility[endpoint][endpoint], friction_), free_n[endpoint],
                                  free_t[endpoint], friction_);
    const std::size_t other = 1 - endpoint;
    const Coupling<W>& by = mobility[other][endpoint];
    const I fits =
        lanes & (free_n[other] + (by.nn * alone[endpoint].normal + by.nt * alone[endpoint].tangent) >= 0.0f);
    Put(fits, alone, force);
    return fits;
  }

  /// Solves for what both endpoints do at the same time. @return the lanes in which that is a solution
  I Try(const Friction& one, const Friction& two, const I& lanes, std::array<Impulse<W>, 2>& force) const {
    const std::array<Friction, 2> friction = {one, two};
    std::array<std::array<F, 5>, 4> row;  // of normal, tangent, normal, tangent; then the right side
    std::array<I, 2> slips;
    std::array<F, 2> edge;  // of the cone: tangent / normal
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t own = 2 * i;
      slips[i] = friction[i].right | friction[i].left;
      edge[i] = L::Select(friction[i].right, L::Splat(friction_), L::Splat(-friction_));
      row[own][4] = -free_n[i];
      row[own + 1][4] = L::Select(slips[i], F{}, -free_t[i]);
      for (std::size_t j = 0; j < 2; ++j) {
        row[own][2 * j] = mobility[i][j].nn;
        row[own][2 * j + 1] = mobility[i][j].nt;
        row[own + 1][2 * j] = L::Select(slips[i], i == j ? -edge[i] : F{}, mobility[i][j].tn);
        row[own + 1][2 * j + 1] = L::Select(slips[i], L::Splat(i == j ? 1.0f : 0.0f), mobility[i][j].tt);
      }
    }
    // All four at once: without friction the two normal impulses of close feet could hardly be told apart.
    std::array<F, 4> inverse;
    for (std::size_t p = 0; p < 4; ++p) {
      inverse[p] = 1.0f / row[p][p];
      for (std::size_t r = p + 1; r < 4; ++r) {
        const F share = row[r][p] * inverse[p];
        for (std::size_t c = p + 1; c < 5; ++c) row[r][c] -= share * row[p][c];
      }
    }
    std::array<F, 4> found;
    for (std::size_t p = 4; p-- > 0;) {
      F left = row[p][4];
      for (std::size_t c = p + 1; c < 4; ++c) left -= row[p][c] * found[c];
      found[p] = left * inverse[p];
    }
    I fits = lanes;
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t own = 2 * i;
      // At the edge of the cone, not beside it by the rounding of the elimination.
      found[own + 1] = L::Select(slips[i], edge[i] * found[own], found[own + 1]);
      fits &= (found[own] >= 0.0f) & (L::Abs(found[own + 1]) <= friction_ * found[own]);
    }
    for (std::size_t i = 0; i < 2; ++i) {
      F slide = free_t[i];
      for (std::size_t j = 0; j < 2; ++j)
        slide += mobility[i][j].tn * found[2 * j] + mobility[i][j].tt * found[2 * j + 1];
      const I to_left = slide <= 0.0f, to_right = slide >= 0.0f;
      fits &= ~slips[i] | L::Select(friction[i].right, to_left, to_right);
    }
    Put(fits, {Impulse<W>{found[0], found[1]}, Impulse<W>{found[2], found[3]}}, force);
    return fits;
  }

  float friction_;
};

}  // namespace gaitsmith
