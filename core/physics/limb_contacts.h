// SPDX-License-Identifier: MIT
// Contacts of figures with moving limbs (model 2). As in contact.h, inelastic and with Coulomb friction, but
// a blow to an endpoint also moves the joints, as far as they give way.
#pragma once

#include <array>

#include "core/physics/contact.h"
#include "core/physics/limb_inertia.h"
#include "core/physics/limb_pair.h"
#include "core/physics/limb_state.h"

namespace gaitsmith {

/// Sweeps over the contacts of one round, at most. One contact needs one, and two are solved without sweeps.
inline constexpr int kLimbSweeps = 50;
inline constexpr int kSmoothSweeps = 400;  // rarely needed, so they may take their time

/// Where the endpoints are at one instant, and how each speed moves them.
template <int W>
struct LimbArms {
  using F = typename Lane<W>::F;
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

  /// Adds the momenta that the ground's impulses on the endpoints give.
  void AddMomenta(const Mechanism& body, const EndpointImpulses<W>& force, LimbNumbers<W>& momenta) const {
    LimbNumbers<W> n, t;
    for (std::size_t k = 0; k < static_cast<std::size_t>(body.endpoints); ++k) {
      RowsOf(body, k, n, t);
      for (std::size_t j = 0; j < static_cast<std::size_t>(body.rods); ++j)
        momenta[j] += n[j] * force.normal[k] + t[j] * force.tangent[k];
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
  LimbContacts(const Mechanism& body, const World& world, const LimbArms<W>& arms,
               const LimbFactor<W>& factor, const I& touching)
      : rods_(static_cast<std::size_t>(body.rods)), friction_(world.friction) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(body.endpoints); ++k) {
      const I present = (touching & (1 << k)) != 0;
      if (!L::Any(present)) continue;
      endpoint_[count_] = k;
      present_[count_] = present;
      arms.RowsOf(body, k, row_n_[count_], row_t_[count_]);
      inward_n_[count_] = row_n_[count_];
      inward_t_[count_] = row_t_[count_];
      factor.SolveInward(inward_n_[count_]);
      factor.SolveInward(inward_t_[count_]);
      ++count_;
    }
    for (std::size_t a = 0; a < count_; ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        const F tn = factor.Between(inward_t_[a], inward_n_[b]);
        const F nt = a == b ? tn : factor.Between(inward_n_[a], inward_t_[b]);
        Coupling<W>& g = mobility_[a][b];
        g = {factor.Between(inward_n_[a], inward_n_[b]) + world.inverse_mass, nt, tn,
             factor.Between(inward_t_[a], inward_t_[b]) + world.inverse_mass};
        mobility_[b][a] = {g.nn, g.tn, g.nt, g.tt};
      }
      own_[a] = MobilityOf<W>(mobility_[a][a], friction_);
    }
  }

  /// Solves for the impulses.
  /// @param since  speeds that the velocities do not contain yet [rad/s]
  /// @param velocity_n, velocity_t  of each endpoint with the present impulses [m/s]; what is left of the way
  /// to the ground counts in n
  /// @param before  impulses of each endpoint when contacts were last solved: what bore, slipped or stuck
  /// then is tried first
  /// @param force   in: the present impulses, out: the solution
  void Solve(const LimbNumbers<W>& since, const std::array<F, kMaxEndpoints>& velocity_n,
             const std::array<F, kMaxEndpoints>& velocity_t, const EndpointImpulses<W>& before,
             EndpointImpulses<W>& force) const {
    std::array<F, kMaxEndpoints> v_n, v_t;
    for (std::size_t a = 0; a < count_; ++a) {
      v_n[a] = velocity_n[endpoint_[a]] + Along(row_n_[a], since);
      v_t[a] = velocity_t[endpoint_[a]] + Along(row_t_[a], since);
    }
    I number{};
    for (std::size_t a = 0; a < count_; ++a) number -= present_[a];
    I settled = number == 0;
    if (L::Any(number == 2)) settled |= SolvePairs(number == 2, v_n, v_t, before, force);
    for (int sweep = 0; sweep < kLimbSweeps && L::Any(~settled); ++sweep) {
      F moved{};
      for (std::size_t turn = 0; turn < count_; ++turn) {
        const std::size_t a = sweep % 2 == 0 ? turn : count_ - 1 - turn;
        const F force_n = force.normal[endpoint_[a]], force_t = force.tangent[endpoint_[a]];
        const Mobility<W>& m = own_[a];
        const Impulse<W> solved = SolveOne<W>(m, v_n[a] - (m.nn * force_n + m.nt * force_t),
                                              v_t[a] - (m.nt * force_n + m.tt * force_t), friction_);
        const Impulse<W> push = {solved.normal - force_n, solved.tangent - force_t};
        const I takes_part = present_[a] & ~settled;
        Set(a, takes_part, solved, v_n, v_t, force);
        moved = L::Max(moved,
                       L::Select(takes_part, L::Abs(push.normal * m.nn) + L::Abs(push.tangent * m.tt), F{}));
      }
      settled |= (moved <= kContactTolerance) | (number == 1);
    }
  }

  /// Solves for the impulses on ground without friction; arguments as above.
  void SolveSmooth(const LimbNumbers<W>& since, const std::array<F, kMaxEndpoints>& velocity_n,
                   EndpointImpulses<W>& force) const {
    std::array<F, kMaxEndpoints> v_n, v_t{};
    for (std::size_t a = 0; a < count_; ++a) v_n[a] = velocity_n[endpoint_[a]] + Along(row_n_[a], since);
    I settled{};
    for (int sweep = 0; sweep < kSmoothSweeps && L::Any(~settled); ++sweep) {
      F moved{};
      for (std::size_t turn = 0; turn < count_; ++turn) {
        const std::size_t a = sweep % 2 == 0 ? turn : count_ - 1 - turn;
        const F& force_n = force.normal[endpoint_[a]];
        const F& force_t = force.tangent[endpoint_[a]];
        const Coupling<W>& own = mobility_[a][a];
        const F without = v_n[a] - own.nn * force_n - own.nt * force_t;
        const F push = L::Max(-without / own.nn, F{}) - force_n;
        const I takes_part = present_[a] & ~settled;
        moved = L::Max(moved, L::Select(takes_part, L::Abs(push * own.nn) + L::Abs(force_t * own.tt), F{}));
        Set(a, takes_part, {force_n + push, F{}}, v_n, v_t, force);
      }
      settled |= moved <= kContactTolerance;
    }
  }

  /// Adds what further impulses do: to the speeds, solved inward, and to the momenta.
  void Apply(const EndpointImpulses<W>& more, LimbNumbers<W>& inward, LimbNumbers<W>& momentum) const {
    for (std::size_t a = 0; a < count_; ++a) {
      const F force_n = more.normal[endpoint_[a]], force_t = more.tangent[endpoint_[a]];
      for (std::size_t j = 0; j < rods_; ++j) {
        inward[j] += inward_n_[a][j] * force_n + inward_t_[a][j] * force_t;
        momentum[j] += row_n_[a][j] * force_n + row_t_[a][j] * force_t;
      }
    }
  }

  [[nodiscard]] bool None() const { return count_ == 0; }

 private:
  /// Gives a contact another impulse in some lanes, and all endpoints their velocities by it.
  void Set(std::size_t contact, const I& lanes, const Impulse<W>& own, std::array<F, kMaxEndpoints>& v_n,
           std::array<F, kMaxEndpoints>& v_t, EndpointImpulses<W>& force) const {
    F& force_n = force.normal[endpoint_[contact]];
    F& force_t = force.tangent[endpoint_[contact]];
    const F push_n = L::Select(lanes, own.normal - force_n, F{});
    const F push_t = L::Select(lanes, own.tangent - force_t, F{});
    force_n = L::Select(lanes, own.normal, force_n);
    force_t = L::Select(lanes, own.tangent, force_t);
    for (std::size_t b = 0; b < count_; ++b) {
      const Coupling<W>& g = mobility_[b][contact];
      v_n[b] += g.nn * push_n + g.nt * push_t;
      v_t[b] += g.tn * push_n + g.tt * push_t;
    }
  }

  /// Solves two contacts exactly. @return the lanes of `two` that are solved
  I SolvePairs(const I& two, std::array<F, kMaxEndpoints>& v_n, std::array<F, kMaxEndpoints>& v_t,
               const EndpointImpulses<W>& before, EndpointImpulses<W>& force) const {
    LimbPair<W> pair(friction_);
    std::array<Impulse<W>, 2> found{};
    if (count_ == 2) {
      for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t k = endpoint_[i];
        found[i] = {force.normal[k], force.tangent[k]};
        pair.before[i] = {before.normal[k], before.tangent[k]};
        pair.free_n[i] = v_n[i];
        pair.free_t[i] = v_t[i];
        for (std::size_t j = 0; j < 2; ++j) pair.mobility[i][j] = mobility_[i][j];
      }
      const I solved = SolvePair(two, pair, found);
      for (std::size_t i = 0; i < 2; ++i) Set(i, solved, found[i], v_n, v_t, force);
      return solved;
    }
    // Each lane's first and second contact.
    std::array<std::array<I, kMaxEndpoints>, 2> is;
    I seen{};
    for (std::size_t a = 0; a < count_; ++a) {
      is[0][a] = present_[a] & (seen == 0);
      is[1][a] = present_[a] & (seen == 1);
      seen -= present_[a];
    }
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t a = 0; a < count_; ++a) {
        const std::size_t k = endpoint_[a];
        found[i] = {L::Select(is[i][a], force.normal[k], found[i].normal),
                    L::Select(is[i][a], force.tangent[k], found[i].tangent)};
        pair.before[i] = {L::Select(is[i][a], before.normal[k], pair.before[i].normal),
                          L::Select(is[i][a], before.tangent[k], pair.before[i].tangent)};
        pair.free_n[i] = L::Select(is[i][a], v_n[a], pair.free_n[i]);
        pair.free_t[i] = L::Select(is[i][a], v_t[a], pair.free_t[i]);
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
      const Impulse<W> own = {L::Select(is[0][a], found[0].normal, found[1].normal),
                              L::Select(is[0][a], found[0].tangent, found[1].tangent)};
      Set(a, solved & present_[a], own, v_n, v_t, force);
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

  F Along(const LimbNumbers<W>& row, const LimbNumbers<W>& answer) const {
    F sum{};
    for (std::size_t j = 0; j < rods_; ++j) sum += row[j] * answer[j];
    return sum;
  }

  std::size_t rods_, count_ = 0;
  float friction_;
  std::array<std::size_t, kMaxEndpoints> endpoint_;
  std::array<I, kMaxEndpoints> present_;
  std::array<LimbNumbers<W>, kMaxEndpoints> row_n_, row_t_, inward_n_, inward_t_;
  std::array<std::array<Coupling<W>, kMaxEndpoints>, kMaxEndpoints> mobility_;
  std::array<Mobility<W>, kMaxEndpoints> own_;
};

}  // namespace gaitsmith
