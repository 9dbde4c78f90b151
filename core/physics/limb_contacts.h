// SPDX-License-Identifier: MIT
// Contacts of figures with moving limbs (model 2). As in contact.h, inelastic and with Coulomb friction, but
// a blow to a limb also moves the joints, as far as they give way.
#pragma once

#include <array>
#include <cstddef>

#include "core/physics/limb_inertia.h"
#include "core/physics/limb_pair.h"

namespace gaitsmith {

/// Places where one figure may touch the ground in one step, at most.
inline constexpr std::size_t kMaxTouches = 20;
static_assert(kMaxTouches >= kMaxEndpoints);
/// Sweeps over the contacts of one round, at most. One contact needs one, and two are solved without sweeps.
inline constexpr int kLimbSweeps = 50;
inline constexpr int kSmoothSweeps = 400;  // rarely needed, so they may take their time

/// A motion is void when the ground pulls, or rubs more than Coulomb says by this share. Between a centimetre
/// and forty metres, rounding errors alone may decide which way a blow moves an endpoint.
inline constexpr float kMaxConeError = 1e-6f;

/// A place where figures may touch the ground, in each lane another one. Impulses and velocities are normal
/// to the ground there (n) and along it to the right (t).
template <int W>
struct LimbTouch {
  using F = typename Lane<W>::F;
  typename Lane<W>::I present{};  // lanes in which there is such a place; in others it gets no impulse
  F normal_x{}, normal_y{};       // out of the ground; (0, 1) on level ground
  LimbNumbers<W> row_n, row_t;    // its velocity by unit speeds [m]
  F velocity_n{}, velocity_t{};   // with the present impulse [m/s]; what is left of the way counts in n
  Impulse<W> before{};            // when contacts were last solved
  Impulse<W> force{};             // in: the present impulse, out: the solution
};

template <int W>
struct TouchList {
  std::size_t count = 0;
  std::array<LimbTouch<W>, kMaxTouches> touches;

  /// Adds the momenta that the present impulses give.
  void AddMomenta(std::size_t rods, LimbNumbers<W>& momenta) const {
    for (std::size_t a = 0; a < count; ++a) {
      const LimbTouch<W>& at = touches[a];
      for (std::size_t j = 0; j < rods; ++j)
        momenta[j] += at.row_n[j] * at.force.normal + at.row_t[j] * at.force.tangent;
    }
  }
};

/// All contacts of W figures in one round.
/// @tparam kLevel whether all normals are (0, 1)
template <int W, bool kLevel>
class LimbContacts {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;

 public:
  LimbContacts(std::size_t rods, const World& world, const LimbFactor<W>& factor, TouchList<W>& list)
      : rods_(rods), count_(list.count), friction_(world.friction), touches_(list.touches) {
    for (std::size_t a = 0; a < count_; ++a) {
      had_[a] = touches_[a].force;
      inward_n_[a] = touches_[a].row_n;
      inward_t_[a] = touches_[a].row_t;
      factor.SolveInward(inward_n_[a]);
      factor.SolveInward(inward_t_[a]);
    }
    for (std::size_t a = 0; a < count_; ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        const F tn = factor.Between(inward_t_[a], inward_n_[b]);
        const F nt = a == b ? tn : factor.Between(inward_n_[a], inward_t_[b]);
        Coupling<W>& g = mobility_[a][b];
        g = {factor.Between(inward_n_[a], inward_n_[b]), nt, tn, factor.Between(inward_t_[a], inward_t_[b])};
        AddWhole(world.inverse_mass, touches_[a], touches_[b], g);
        mobility_[b][a] = {g.nn, g.tn, g.nt, g.tt};
      }
      own_[a] = MobilityOf<W>(mobility_[a][a], friction_);
    }
  }

  /// Solves for the impulses. What the places did before is tried first.
  /// @param since  speeds that the velocities do not contain yet [rad/s]
  void Solve(const LimbNumbers<W>& since) {
    Begin(since);
    I number{};
    for (std::size_t a = 0; a < count_; ++a) number -= touches_[a].present;
    I settled = number == 0;
    if (L::Any(number == 2)) settled |= SolvePairs(number == 2);
    for (int sweep = 0; sweep < kLimbSweeps && L::Any(~settled); ++sweep) {
      F moved{};
      for (std::size_t turn = 0; turn < count_; ++turn) {
        const std::size_t a = sweep % 2 == 0 ? turn : count_ - 1 - turn;
        const Impulse<W> force = touches_[a].force;
        const Mobility<W>& m = own_[a];
        const Impulse<W> solved =
            SolveOne<W>(m, v_n_[a] - (m.nn * force.normal + m.nt * force.tangent),
                        v_t_[a] - (m.nt * force.normal + m.tt * force.tangent), friction_);
        const Impulse<W> push = {solved.normal - force.normal, solved.tangent - force.tangent};
        const I takes_part = touches_[a].present & ~settled;
        Set(a, takes_part, solved);
        moved = L::Max(moved,
                       L::Select(takes_part, L::Abs(push.normal * m.nn) + L::Abs(push.tangent * m.tt), F{}));
      }
      settled |= (moved <= kContactTolerance) | (number == 1);
    }
  }

  /// Solves for the impulses of ground without friction; argument as above.
  void SolveSmooth(const LimbNumbers<W>& since) {
    Begin(since);
    I settled{};
    for (int sweep = 0; sweep < kSmoothSweeps && L::Any(~settled); ++sweep) {
      F moved{};
      for (std::size_t turn = 0; turn < count_; ++turn) {
        const std::size_t a = sweep % 2 == 0 ? turn : count_ - 1 - turn;
        const Impulse<W> force = touches_[a].force;
        const Coupling<W>& own = mobility_[a][a];
        const F without = v_n_[a] - own.nn * force.normal - own.nt * force.tangent;
        const F push = L::Max(-without / own.nn, F{}) - force.normal;
        const I takes_part = touches_[a].present & ~settled;
        moved =
            L::Max(moved, L::Select(takes_part, L::Abs(push * own.nn) + L::Abs(force.tangent * own.tt), F{}));
        Set(a, takes_part, {force.normal + push, F{}});
      }
      settled |= moved <= kContactTolerance;
    }
  }

  /// Adds what the impulses have gained by the solution: to the speeds, solved inward, and to the momenta.
  void Apply(LimbNumbers<W>& inward, LimbNumbers<W>& momenta) const {
    for (std::size_t a = 0; a < count_; ++a) {
      const LimbTouch<W>& at = touches_[a];
      const F more_n = at.force.normal - had_[a].normal, more_t = at.force.tangent - had_[a].tangent;
      for (std::size_t j = 0; j < rods_; ++j) {
        inward[j] += inward_n_[a][j] * more_n + inward_t_[a][j] * more_t;
        momenta[j] += at.row_n[j] * more_n + at.row_t[j] * more_t;
      }
    }
  }

 private:
  /// Adds how the figure as a whole answers.
  static void AddWhole(float inverse_mass, const LimbTouch<W>& a, const LimbTouch<W>& b, Coupling<W>& g) {
    if constexpr (kLevel) {
      g.nn += inverse_mass;
      g.tt += inverse_mass;
    } else {
      const F same = inverse_mass * (a.normal_x * b.normal_x + a.normal_y * b.normal_y);
      const F across = inverse_mass * (a.normal_x * b.normal_y - a.normal_y * b.normal_x);
      g.nn += same;
      g.tt += same;
      g.nt += across;
      g.tn -= across;
    }
  }

  void Begin(const LimbNumbers<W>& since) {
    for (std::size_t a = 0; a < count_; ++a) {
      v_n_[a] = touches_[a].velocity_n + Along(touches_[a].row_n, since);
      v_t_[a] = touches_[a].velocity_t + Along(touches_[a].row_t, since);
    }
  }

  /// Gives a contact another impulse in some lanes, and all contacts their velocities by it.
  void Set(std::size_t contact, const I& lanes, const Impulse<W>& own) {
    Impulse<W>& force = touches_[contact].force;
    const F push_n = L::Select(lanes, own.normal - force.normal, F{});
    const F push_t = L::Select(lanes, own.tangent - force.tangent, F{});
    force = {L::Select(lanes, own.normal, force.normal), L::Select(lanes, own.tangent, force.tangent)};
    for (std::size_t b = 0; b < count_; ++b) {
      const Coupling<W>& g = mobility_[b][contact];
      v_n_[b] += g.nn * push_n + g.nt * push_t;
      v_t_[b] += g.tn * push_n + g.tt * push_t;
    }
  }

  /// Solves two contacts exactly. @return the lanes of `two` that are solved
  I SolvePairs(const I& two) {
    LimbPair<W> pair(friction_);
    std::array<Impulse<W>, 2> found{};
    if (count_ == 2) {
      for (std::size_t i = 0; i < 2; ++i) {
        found[i] = touches_[i].force;
        pair.before[i] = touches_[i].before;
        pair.free_n[i] = v_n_[i];
        pair.free_t[i] = v_t_[i];
        for (std::size_t j = 0; j < 2; ++j) pair.mobility[i][j] = mobility_[i][j];
      }
      const I solved = SolvePair(two, pair, found);
      for (std::size_t i = 0; i < 2; ++i) Set(i, solved, found[i]);
      return solved;
    }
    // Each lane's first and second contact.
    std::array<std::array<I, kMaxTouches>, 2> is;
    I seen{};
    for (std::size_t a = 0; a < count_; ++a) {
      is[0][a] = touches_[a].present & (seen == 0);
      is[1][a] = touches_[a].present & (seen == 1);
      seen -= touches_[a].present;
    }
    const auto take = [](const I& lanes, const Impulse<W>& from, Impulse<W>& to) {
      to = {L::Select(lanes, from.normal, to.normal), L::Select(lanes, from.tangent, to.tangent)};
    };
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t a = 0; a < count_; ++a) {
        take(is[i][a], touches_[a].force, found[i]);
        take(is[i][a], touches_[a].before, pair.before[i]);
        pair.free_n[i] = L::Select(is[i][a], v_n_[a], pair.free_n[i]);
        pair.free_t[i] = L::Select(is[i][a], v_t_[a], pair.free_t[i]);
        for (std::size_t j = 0; j < 2; ++j) {
          for (std::size_t b = 0; b < count_; ++b) {
            const I both = is[i][a] & is[j][b];
            const Coupling<W>& from = mobility_[a][b];
            Coupling<W>& to = pair.mobility[i][j];
            to = {L::Select(both, from.nn, to.nn), L::Select(both, from.nt, to.nt),
                  L::Select(both, from.tn, to.tn), L::Select(both, from.tt, to.tt)};
          }
        }
      }
    }
    const I solved = SolvePair(two, pair, found);
    for (std::size_t a = 0; a < count_; ++a) {
      Impulse<W> own = found[1];
      take(is[0][a], found[0], own);
      Set(a, solved & touches_[a].present, own);
    }
    return solved;
  }

  /// @param pair   with the velocities under the impulses `found`
  /// @param found  in: the present impulses, out: the solution
  I SolvePair(const I& lanes, LimbPair<W>& pair, std::array<Impulse<W>, 2>& found) const {
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) {
        const Coupling<W>& g = pair.mobility[i][j];
        pair.free_n[i] -= g.nn * found[j].normal + g.nt * found[j].tangent;
        pair.free_t[i] -= g.tn * found[j].normal + g.tt * found[j].tangent;
      }
    }
    return pair.Solve(lanes, found);
  }

  F Along(const LimbNumbers<W>& row, const LimbNumbers<W>& speeds) const {
    F sum{};
    for (std::size_t j = 0; j < rods_; ++j) sum += row[j] * speeds[j];
    return sum;
  }

  std::size_t rods_, count_;
  float friction_;
  std::array<LimbTouch<W>, kMaxTouches>& touches_;
  std::array<Impulse<W>, kMaxTouches> had_;
  std::array<F, kMaxTouches> v_n_, v_t_;
  std::array<LimbNumbers<W>, kMaxTouches> inward_n_, inward_t_;
  std::array<std::array<Coupling<W>, kMaxTouches>, kMaxTouches> mobility_;
  std::array<Mobility<W>, kMaxTouches> own_;
};

}  // namespace gaitsmith
