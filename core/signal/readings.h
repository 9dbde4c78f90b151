// SPDX-License-Identifier: MIT
// What W plants report after a step, in physical units: all that controllers and style meters read.
#pragma once

#include "core/numeric/lane.h"

namespace gaitsmith {

/// Pointers into the plant, valid until it steps again or is gone.
template <int W>
struct Readings {
  using F = typename Lane<W>::F;
  const F* position;  // of each actuator: angles of joints [rad]
  const F* rate;      // [rad/s]
  const F* change;    // of position in the last step [rad]; may differ from rate * h
  const F* impulse;   // of the ground in the last step at each contact, away from the ground [N s], >= 0
  const F* height;    // of the centre of mass above the ground [m]
  const F* rise;      // its velocity away from the ground [m/s]
};

}  // namespace gaitsmith
