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
  std::array<std::array<Coupling<W>, 2>, 2> mobility{};
  std::array<F, 2> free_n{}, free_t{};  // velocities without the two impulses [m/s]

  /// Finds the impulses that satisfy contact and friction at both endpoints. There may be several solutions
  /// (Painleve's paradox), so the same order applies as in model 1: both endpoints bear before one bears
  /// alone, both stick before one slips, and of the others the least friction is taken.
  /// @return the lanes that have a solution
  I Solve(float friction, std::array<Impulse<W>, 2>& force) const {
    I done = Try(Mode::kStick, Mode::kStick, friction, force, ~I{});
    if (!L::Any(~done)) return done;
    I found{};
    std::array<Impulse<W>, 2> best{};
    F least{};
    I open = ~done;
    const auto offer = [&](Mode one, Mode two) {
      std::array<Impulse<W>, 2> candidate{};
      const I fits = Try(one, two, friction, candidate, open);
      const F sum = L::Abs(candidate[0].tangent + candidate[1].tangent);
      const I better = fits & (~found | (sum < least));
      least = L::Select(better, sum, least);
      Put(better, candidate, best);
      found |= fits;
    };
    offer(Mode::kStick, Mode::kRight);
    offer(Mode::kStick, Mode::kLeft);
    offer(Mode::kRight, Mode::kStick);
    offer(Mode::kLeft, Mode::kStick);
    open = ~(done | found);
    if (L::Any(open)) {
      offer(Mode::kRight, Mode::kRight);
      offer(Mode::kLeft, Mode::kLeft);
      offer(Mode::kRight, Mode::kLeft);
      offer(Mode::kLeft, Mode::kRight);
    }
    Put(found, best, force);
    done |= found;
    if (!L::Any(~done)) return done;
    for (std::size_t i = 0; i < 2; ++i) {
      // One bears alone, if that keeps the other from the ground.
      std::array<Impulse<W>, 2> alone{};
      alone[i] = SolveOne<W>(MobilityOf<W>(mobility[i][i], friction), free_n[i], free_t[i], friction);
      const Coupling<W>& other = mobility[1 - i][i];
      const F away = free_n[1 - i] + (other.nn * alone[i].normal + other.nt * alone[i].tangent);
      const I fits = ~done & (away >= 0.0f);
      Put(fits, alone, force);
      done |= fits;
    }
    return done;
  }

 private:
  enum class Mode { kStick, kRight, kLeft };  // of friction: it pushes right, or left

  static void Put(const I& lanes, const std::array<Impulse<W>, 2>& from, std::array<Impulse<W>, 2>& to) {
    for (std::size_t i = 0; i < 2; ++i) {
      to[i] = {L::Select(lanes, from[i].normal, to[i].normal),
               L::Select(lanes, from[i].tangent, to[i].tangent)};
    }
  }

  /// Solves for what both endpoints do at the same time, and puts it where it is a solution.
  I Try(Mode one, Mode two, float friction, std::array<Impulse<W>, 2>& force, const I& lanes) const {
    const std::array<Mode, 2> modes = {one, two};
    std::array<std::array<F, 5>, 4> row{};  // of normal, tangent, normal, tangent; then the right side
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t own = 2 * i;
      row[own][4] = -free_n[i];
      for (std::size_t j = 0; j < 2; ++j) {
        row[own][2 * j] = mobility[i][j].nn;
        row[own][2 * j + 1] = mobility[i][j].nt;
        if (modes[i] != Mode::kStick) continue;
        row[own + 1][2 * j] = mobility[i][j].tn;
        row[own + 1][2 * j + 1] = mobility[i][j].tt;
      }
      if (modes[i] == Mode::kStick) {
        row[own + 1][4] = -free_t[i];
      } else {
        row[own + 1][own] = L::Splat(modes[i] == Mode::kRight ? -friction : friction);
        row[own + 1][own + 1] = L::Splat(1.0f);
      }
    }
    // All four at once: without friction the two normal impulses of close feet could hardly be told apart.
    for (std::size_t p = 0; p < 4; ++p) {
      const F inverse = 1.0f / row[p][p];
      for (std::size_t r = p + 1; r < 4; ++r) {
        const F share = row[r][p] * inverse;
        for (std::size_t c = p + 1; c < 5; ++c) row[r][c] -= share * row[p][c];
      }
    }
    std::array<F, 4> found;
    for (std::size_t p = 4; p-- > 0;) {
      F left = row[p][4];
      for (std::size_t c = p + 1; c < 4; ++c) left -= row[p][c] * found[c];
      found[p] = left / row[p][p];
    }
    // At the edge of the cone, not beside it by the rounding of the elimination.
    for (std::size_t i = 0; i < 2; ++i) {
      if (modes[i] != Mode::kStick)
        found[2 * i + 1] = (modes[i] == Mode::kRight ? friction : -friction) * found[2 * i];
    }
    I fits = lanes;
    for (std::size_t i = 0; i < 2; ++i) {
      const F n = found[2 * i], t = found[2 * i + 1];
      fits &= n >= 0.0f;
      if (modes[i] == Mode::kStick) {
        fits &= L::Abs(t) <= friction * n;
        continue;
      }
      F slide = free_t[i];
      for (std::size_t j = 0; j < 2; ++j)
        slide += mobility[i][j].tn * found[2 * j] + mobility[i][j].tt * found[2 * j + 1];
      fits &= modes[i] == Mode::kRight ? slide <= 0.0f : slide >= 0.0f;
    }
    Put(fits, {Impulse<W>{found[0], found[1]}, Impulse<W>{found[2], found[3]}}, force);
    return fits;
  }
};

}  // namespace gaitsmith
