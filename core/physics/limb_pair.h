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
  I Solve(float friction, std::array<Impulse<W>, 2>& force) {
    Reduce();
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
    // Only where none sticks: another lane's need must not offer more to this one.
    open &= ~found;
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

  /// While both endpoints stay on the ground, friction decides about everything else: the normal impulses are
  /// normal_0 - normal_t tangent, and the slides slide_0 + slide_t tangent.
  void Reduce() {
    const auto& g = mobility;
    const F inverse = 1.0f / (g[0][0].nn * g[1][1].nn - g[0][1].nn * g[1][0].nn);
    const std::array<std::array<F, 2>, 2> stop = {
        {{g[1][1].nn * inverse, -g[0][1].nn * inverse}, {-g[1][0].nn * inverse, g[0][0].nn * inverse}}};
    for (std::size_t i = 0; i < 2; ++i) {
      normal_0_[i] = -(stop[i][0] * free_n[0] + stop[i][1] * free_n[1]);
      for (std::size_t j = 0; j < 2; ++j) normal_t_[i][j] = stop[i][0] * g[0][j].nt + stop[i][1] * g[1][j].nt;
    }
    for (std::size_t i = 0; i < 2; ++i) {
      slide_0_[i] = free_t[i] + (g[i][0].tn * normal_0_[0] + g[i][1].tn * normal_0_[1]);
      for (std::size_t j = 0; j < 2; ++j)
        slide_t_[i][j] = g[i][j].tt - (g[i][0].tn * normal_t_[0][j] + g[i][1].tn * normal_t_[1][j]);
    }
  }

  /// Solves for what both endpoints do at the same time, and puts it where it is a solution.
  I Try(Mode one, Mode two, float friction, std::array<Impulse<W>, 2>& force, const I& lanes) const {
    const std::array<Mode, 2> modes = {one, two};
    std::array<std::array<F, 2>, 2> row;  // of the two tangents
    std::array<F, 2> right;
    for (std::size_t i = 0; i < 2; ++i) {
      if (modes[i] == Mode::kStick) {
        row[i] = slide_t_[i];
        right[i] = -slide_0_[i];
        continue;
      }
      const float per_n = modes[i] == Mode::kRight ? friction : -friction;
      for (std::size_t j = 0; j < 2; ++j) row[i][j] = (i == j ? 1.0f : 0.0f) + per_n * normal_t_[i][j];
      right[i] = per_n * normal_0_[i];
    }
    const F inverse = 1.0f / (row[0][0] * row[1][1] - row[0][1] * row[1][0]);
    const std::array<F, 2> t = {(right[0] * row[1][1] - right[1] * row[0][1]) * inverse,
                                (right[1] * row[0][0] - right[0] * row[1][0]) * inverse};
    I fits = lanes;
    std::array<Impulse<W>, 2> found;
    for (std::size_t i = 0; i < 2; ++i) {
      const F n = normal_0_[i] - (normal_t_[i][0] * t[0] + normal_t_[i][1] * t[1]);
      fits &= n >= 0.0f;
      if (modes[i] == Mode::kStick) {
        found[i] = {n, t[i]};
        fits &= L::Abs(t[i]) <= friction * n;
        continue;
      }
      const bool right_side = modes[i] == Mode::kRight;
      found[i] = {n, (right_side ? friction : -friction) * n};
      const F slide = slide_0_[i] + (slide_t_[i][0] * t[0] + slide_t_[i][1] * t[1]);
      fits &= right_side ? slide <= 0.0f : slide >= 0.0f;
    }
    Put(fits, found, force);
    return fits;
  }

  std::array<F, 2> normal_0_, slide_0_;
  std::array<std::array<F, 2>, 2> normal_t_, slide_t_;
};

}  // namespace gaitsmith
