// SPDX-License-Identifier: MIT
// Three or more endpoints on the ground at once: projected Gauss-Seidel with accumulated impulses
// [Catto 2005]. Each endpoint in turn is solved exactly.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/physics/contact.h"

namespace gaitsmith {

/// Starts from the impulses stored in the contacts. Sweeps alternate between forward and backward, so that
/// neither end of a figure is favoured. A lane that a sweep hardly changes is settled and no longer updated.
/// Its result therefore does not depend on the other lanes.
/// @param present lanes in which each contact takes part. In the other lanes its impulse is 0 and stays 0.
template <int W>
void SolveMany(const World& world, Body<W> body, std::span<Contact<W>> contacts,
               std::span<const typename Lane<W>::I> present) {
  using L = Lane<W>;
  using F = typename L::F;
  using I = typename L::I;
  std::array<Mobility<W>, kMaxEndpoints> mobilities;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    mobilities[i] = Mobility<W>(world, body, contacts[i].arm);
    body.Push(world, contacts[i].arm, contacts[i].force);
  }
  I settled{};
  for (int sweep = 0; sweep < kContactSweeps; ++sweep) {
    F moved{};
    for (std::size_t turn = 0; turn < contacts.size(); ++turn) {
      const std::size_t i = sweep % 2 == 0 ? turn : contacts.size() - 1 - turn;
      Contact<W>& c = contacts[i];
      const Mobility<W>& m = mobilities[i];
      const F b_n = c.Approach(body) - (m.nn * c.force.normal + m.nt * c.force.tangent);
      const F b_t = c.Slide(body) - (m.nt * c.force.normal + m.tt * c.force.tangent);
      const Impulse<W> solved = SolveOne<W>(m, b_n, b_t, world.friction);
      const I takes_part = present[i] & ~settled;
      const Impulse<W> push = {L::Select(takes_part, solved.normal - c.force.normal, F{}),
                               L::Select(takes_part, solved.tangent - c.force.tangent, F{})};
      c.force.normal = L::Select(takes_part, solved.normal, c.force.normal);
      c.force.tangent = L::Select(takes_part, solved.tangent, c.force.tangent);
      body.Push(world, c.arm, push);
      moved += L::Abs(push.normal) + L::Abs(push.tangent);
    }
    settled |= moved * world.inverse_mass <= kContactTolerance;
    if (!L::Any(~settled)) break;
  }
}

}  // namespace gaitsmith
