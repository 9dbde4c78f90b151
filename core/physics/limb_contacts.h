// SPDX-License-Identifier: MIT
// Contacts of figures with moving limbs (model 2). As in contact.h, inelastic and with Coulomb friction, but
// a blow to an endpoint also moves the joints, as far as they give way.
#pragma once

#include <array>

#include "core/physics/contact.h"
#include "core/physics/limb_inertia.h"

namespace gaitsmith {

/// Sweeps over the contacts of one round, at most. Two contacts need one or two.
inline constexpr int kLimbSweeps = 50;

/// Where the endpoints are at one instant, and how each speed moves them.
template <int W>
struct LimbArms {
  using F = typename Lane<W>::F;
  std::array<F, kMaxEndpoints> x, y;       // endpoints from the centre of mass [m]
  LimbNumbers<W> pull_x, pull_y;           // how the centre of mass moves with a joint, seen from it [m]

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
};

/// All contacts of W figures in one round. The contacts are the endpoints that touch in any lane; in lanes
/// where one does not, it gets no impulse.
template <int W>
class LimbContacts {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;

 public:
  /// @param touching bit mask of endpoints per lane
  LimbContacts(const Mechanism& body, const World& world, const LimbArms<W>& arms, const LimbFactor<W>& factor,
               const I& touching)
      : rods_(static_cast<std::size_t>(body.rods)), friction_(world.friction) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(body.endpoints); ++k) {
      const I present = (touching & (1 << k)) != 0;
      if (!L::Any(present)) continue;
      endpoint_[count_] = k;
      present_[count_] = present;
      arms.RowsOf(body, k, row_n_[count_], row_t_[count_]);
      answer_n_[count_] = row_n_[count_];
      answer_t_[count_] = row_t_[count_];
      factor.Solve(answer_n_[count_]);
      factor.Solve(answer_t_[count_]);
      ++count_;
    }
    for (std::size_t a = 0; a < count_; ++a) {
      for (std::size_t b = 0; b < count_; ++b) {
        Cross& g = mobility_[a][b];
        g = {Along(row_n_[a], answer_n_[b]) + world.inverse_mass, Along(row_n_[a], answer_t_[b]),
             Along(row_t_[a], answer_n_[b]), Along(row_t_[a], answer_t_[b]) + world.inverse_mass};
      }
      const Cross& own = mobility_[a][a];
      Mobility<W>& m = own_[a];
      m.nn = own.nn;
      m.nt = own.nt;
      m.tt = own.tt;
      m.inverse_determinant = 1.0f / (own.nn * own.tt - own.nt * own.nt);
      m.right_per_n = 1.0f / (own.nn + friction_ * own.nt);
      m.left_per_n = 1.0f / (own.nn - friction_ * own.nt);
    }
  }

  /// Solves for the impulses. @param since speeds that the velocities do not contain yet
  /// @param velocity_n, velocity_t of each endpoint with the present impulses; of n
  /// what is left of the way to the ground counts as well [m/s]
  /// @param normal, tangent impulses of each endpoint; in: the present ones
  void Solve(const LimbNumbers<W>& since, const std::array<F, kMaxEndpoints>& velocity_n, const std::array<F, kMaxEndpoints>& velocity_t,
             std::array<F, kMaxEndpoints>& normal, std::array<F, kMaxEndpoints>& tangent) const {
    std::array<F, kMaxEndpoints> v_n, v_t;
    for (std::size_t a = 0; a < count_; ++a) {
      v_n[a] = velocity_n[endpoint_[a]] + Along(row_n_[a], since);
      v_t[a] = velocity_t[endpoint_[a]] + Along(row_t_[a], since);
    }
    I settled{};
    for (int sweep = 0; sweep < kLimbSweeps; ++sweep) {
      F moved{};
      for (std::size_t turn = 0; turn < count_; ++turn) {
        const std::size_t a = sweep % 2 == 0 ? turn : count_ - 1 - turn;
        F& force_n = normal[endpoint_[a]];
        F& force_t = tangent[endpoint_[a]];
        const Mobility<W>& m = own_[a];
        const Impulse<W> solved = SolveOne<W>(m, v_n[a] - (m.nn * force_n + m.nt * force_t),
                                              v_t[a] - (m.nt * force_n + m.tt * force_t), friction_);
        const I takes_part = present_[a] & ~settled;
        const F push_n = L::Select(takes_part, solved.normal - force_n, F{});
        const F push_t = L::Select(takes_part, solved.tangent - force_t, F{});
        force_n = L::Select(takes_part, solved.normal, force_n);
        force_t = L::Select(takes_part, solved.tangent, force_t);
        Push(a, push_n, push_t, v_n, v_t);
        moved = L::Max(moved, L::Abs(push_n * m.nn) + L::Abs(push_t * m.tt));
      }
      settled |= moved <= kContactTolerance;
      if (!L::Any(~settled)) break;
      // The sweeps soon know which endpoints stick, slip or leave, but may need many more to finish.
      if (sweep == 1 || sweep == 4 || sweep == 12) settled |= FinishPairs(~settled, v_n, v_t, normal, tangent);
    }
  }

  /// Adds what further impulses do: to the speeds if the joints may give way, and to the momenta.
  void Apply(const std::array<F, kMaxEndpoints>& normal, const std::array<F, kMaxEndpoints>& tangent,
             LimbNumbers<W>& speed, LimbNumbers<W>& momentum) const {
    for (std::size_t a = 0; a < count_; ++a) {
      const F force_n = normal[endpoint_[a]], force_t = tangent[endpoint_[a]];
      for (std::size_t j = 0; j < rods_; ++j) {
        speed[j] += answer_n_[a][j] * force_n + answer_t_[a][j] * force_t;
        momentum[j] += row_n_[a][j] * force_n + row_t_[a][j] * force_t;
      }
    }
  }

  [[nodiscard]] bool None() const { return count_ == 0; }

 private:
  struct Cross {
    F nn, nt, tn, tt;
  };
  /// Adds to the endpoints' velocities what a push on one of them does.
  void Push(std::size_t contact, const F& push_n, const F& push_t, std::array<F, kMaxEndpoints>& v_n,
            std::array<F, kMaxEndpoints>& v_t) const {
    for (std::size_t b = 0; b < count_; ++b) {
      const Cross& g = mobility_[b][contact];
      v_n[b] += g.nn * push_n + g.nt * push_t;
      v_t[b] += g.tn * push_n + g.tt * push_t;
    }
  }

  /// Solves two contacts exactly, given what each of them does at present: leave, stick, or slip to one side.
  /// @return the lanes of `open` where exactly two endpoints touch and this is a solution
  I FinishPairs(const I& open, std::array<F, kMaxEndpoints>& v_n, std::array<F, kMaxEndpoints>& v_t,
                std::array<F, kMaxEndpoints>& normal, std::array<F, kMaxEndpoints>& tangent) const {
    I number{};
    for (std::size_t a = 0; a < count_; ++a) number -= present_[a];
    const I two = open & (number == 2);
    if (!L::Any(two)) return two;
    // Each lane's first and second contact.
    std::array<std::array<I, kMaxEndpoints>, 2> is;
    I before{};
    for (std::size_t a = 0; a < count_; ++a) {
      is[0][a] = present_[a] & (before == 0);
      is[1][a] = present_[a] & (before == 1);
      before -= present_[a];
    }
    std::array<std::array<F, 5>, 4> row{};  // of normal, tangent, normal, tangent; then the right side
    std::array<I, 2> leaves, sticks;
    std::array<F, 2> side, force_n, force_t, free_n, free_t;
    std::array<std::array<Cross, 2>, 2> g{};
    for (std::size_t i = 0; i < 2; ++i) {
      F n{}, t{}, at_n{}, at_t{};
      for (std::size_t a = 0; a < count_; ++a) {
        n = L::Select(is[i][a], normal[endpoint_[a]], n);
        t = L::Select(is[i][a], tangent[endpoint_[a]], t);
        at_n = L::Select(is[i][a], v_n[a], at_n);
        at_t = L::Select(is[i][a], v_t[a], at_t);
        for (std::size_t b = 0; b < count_; ++b) {
          for (std::size_t j = 0; j < 2; ++j) {
            const I both = is[i][a] & is[j][b];
            const Cross& from = mobility_[a][b];
            Cross& to = g[i][j];
            to = {L::Select(both, from.nn, to.nn), L::Select(both, from.nt, to.nt),
                  L::Select(both, from.tn, to.tn), L::Select(both, from.tt, to.tt)};
          }
        }
      }
      force_n[i] = n;
      force_t[i] = t;
      free_n[i] = at_n;
      free_t[i] = at_t;
    }
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) {
        free_n[i] -= g[i][j].nn * force_n[j] + g[i][j].nt * force_t[j];
        free_t[i] -= g[i][j].tn * force_n[j] + g[i][j].tt * force_t[j];
      }
      leaves[i] = force_n[i] <= 0.0f;
      sticks[i] = L::Abs(force_t[i]) < friction_ * force_n[i] * 0.9999f;
      side[i] = L::Select(force_t[i] < 0.0f, L::Splat(-friction_), L::Splat(friction_));
      const std::size_t own = 2 * i, other = 2 - own;
      row[own] = {};
      row[own + 1] = {};
      const auto put = [&](std::size_t r, std::size_t column, const F& value) { row[r][column] = value; };
      put(own, own, L::Select(leaves[i], L::Splat(1.0f), g[i][i].nn));
      put(own, own + 1, L::Select(leaves[i], F{}, g[i][i].nt));
      put(own, other, L::Select(leaves[i], F{}, g[i][1 - i].nn));
      put(own, other + 1, L::Select(leaves[i], F{}, g[i][1 - i].nt));
      put(own, 4, L::Select(leaves[i], F{}, -free_n[i]));
      const I stuck = sticks[i] & ~leaves[i];
      put(own + 1, own, L::Select(stuck, g[i][i].tn, L::Select(leaves[i], F{}, -side[i])));
      put(own + 1, own + 1, L::Select(stuck, g[i][i].tt, L::Splat(1.0f)));
      put(own + 1, other, L::Select(stuck, g[i][1 - i].tn, F{}));
      put(own + 1, other + 1, L::Select(stuck, g[i][1 - i].tt, F{}));
      put(own + 1, 4, L::Select(stuck, -free_t[i], F{}));
    }
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
    I fits = two;
    for (std::size_t i = 0; i < 2; ++i) {
      const F n = found[2 * i], t = found[2 * i + 1];
      const F end_n = free_n[i] + g[i][0].nn * found[0] + g[i][0].nt * found[1] + g[i][1].nn * found[2] +
                      g[i][1].nt * found[3];
      const F end_t = free_t[i] + g[i][0].tn * found[0] + g[i][0].tt * found[1] + g[i][1].tn * found[2] +
                      g[i][1].tt * found[3];
      // Ten times the tolerance, because rounding grows with the speeds before the blow.
      constexpr float kSmall = 10.0f * kContactTolerance;
      const I stays = (n >= 0.0f) & (L::Abs(end_n) <= kSmall) & (L::Abs(t) <= friction_ * n);
      const I slides = ~sticks[i] & (side[i] * end_t <= 0.0f) & (n >= 0.0f) & (L::Abs(end_n) <= kSmall);
      fits &= L::Select(leaves[i], end_n >= -kSmall, L::Select(sticks[i], stays & (L::Abs(end_t) <= kSmall), slides));
    }
    for (std::size_t a = 0; a < count_; ++a) {
      const F n = L::Select(is[0][a], found[0], found[2]), t = L::Select(is[0][a], found[1], found[3]);
      const I takes = fits & present_[a];
      F& force_n_now = normal[endpoint_[a]];
      F& force_t_now = tangent[endpoint_[a]];
      const F push_n = L::Select(takes, n - force_n_now, F{}), push_t = L::Select(takes, t - force_t_now, F{});
      force_n_now = L::Select(takes, n, force_n_now);
      force_t_now = L::Select(takes, t, force_t_now);
      Push(a, push_n, push_t, v_n, v_t);
    }
    return fits;
  }

  F Along(const LimbNumbers<W>& row, const LimbNumbers<W>& answer) const {
    F sum{};
    for (std::size_t j = 0; j < rods_; ++j) sum += row[j] * answer[j];
    return sum;
  }

  std::size_t rods_, count_ = 0;
  float friction_;
  std::array<std::size_t, kMaxEndpoints> endpoint_;
  std::array<I, kMaxEndpoints> present_;
  std::array<LimbNumbers<W>, kMaxEndpoints> row_n_, row_t_, answer_n_, answer_t_;
  std::array<std::array<Cross, kMaxEndpoints>, kMaxEndpoints> mobility_;
  std::array<Mobility<W>, kMaxEndpoints> own_;
};

}  // namespace gaitsmith
