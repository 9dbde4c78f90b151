// SPDX-License-Identifier: MIT
// What W plants report after a step, in physical units. Controllers and style meters read nothing else.
#pragma once

#include "core/numeric/lane.h"
#include "core/world/terrain.h"

namespace gaitsmith {

/// Pointers into the plant, valid until it steps again or is destroyed.
template <int W>
struct Readings {
  using F = typename Lane<W>::F;
  const F* position;  // of each actuator, [rad] for joints
  const F* rate;      // of each actuator [rad/s]
  const F* change;    // change of position in the last step [rad]; may differ from rate * h
  const F* impulse;   // of the ground on each contact in the last step, away from the ground [N s], >= 0
  const F* height;    // of the centre of mass above the ground [m]
  const F* rise;      // velocity of the centre of mass away from the ground [m/s]
  const Terrain* terrain = nullptr;            // nullptr: level ground
  const typename Lane<W>::D* place = nullptr;  // of the centre of mass along the terrain [m]; nullptr: level
};

}  // namespace gaitsmith
