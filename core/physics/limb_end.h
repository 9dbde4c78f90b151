// SPDX-License-Identifier: MIT
// Where the points of W figures end in a step, as far as it is known (model 2).
#pragma once

#include <array>

#include "core/physics/limb_state.h"
#include "core/physics/world.h"

namespace gaitsmith {

/// A limb may end this deep in the ground [m] before the contacts are solved again.
inline constexpr float kLimbSink = 2e-5f;

template <int W>
struct LimbEnd {
  using F = typename Lane<W>::F;
  /// By what the endpoints move, seen from the centre of mass [m]. Not the difference of two places, whose
  /// rounding is the same in every step at rest, and would let figures creep.
  std::array<F, kMaxEndpoints> move_x{}, move_y{};
  F path_x{}, path_y{};  // of the centre of mass [m]
};

/// The sum of the ground's impulses on a figure.
template <int W>
struct GroundSum {
  typename Lane<W>::F along{}, up{};  // [N s]
  typename Lane<W>::I bears{};        // lanes in which something bears
};

/// The path of the centre of mass in a step [m]: with half of this step's gravity in flight, which makes free
/// fall exact, and with all of it where something bears.
template <int W>
void SetPath(const World& world, const LimbState<W>& s, const GroundSum<W>& sum, LimbEnd<W>& end) {
  using L = Lane<W>;
  using F = typename L::F;
  const F fall_x = L::Select(sum.bears, F{}, L::Splat(0.5f * world.fall_x));
  const F fall_y = L::Select(sum.bears, F{}, L::Splat(0.5f * world.fall_y));
  end.path_x = world.step_s * (s.velocity_x - fall_x + sum.along * world.inverse_mass);
  end.path_y = world.step_s * (s.velocity_y - fall_y + sum.up * world.inverse_mass);
}

}  // namespace gaitsmith
