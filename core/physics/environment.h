// SPDX-License-Identifier: MIT
// The world a figure moves in: ground, gravity, how it starts, and who pushes it.
#pragma once

#include <vector>

#include "core/physics/constants.h"

namespace gaitsmith {

/// The ground is the line y = 0 of a frame that is tilted with it, so a slope is only a tilted gravity:
/// exact, and no height has to be subtracted from another one far away.
struct Environment {
  float gravity_mps2 = kStandardGravity;  // [0, 100]
  float friction = 0.8f;                  // Coulomb coefficient, [0, 10]
  float slope_rad = 0.0f;                 // uphill to the right, [-0.6, 0.6]

  bool operator==(const Environment&) const = default;
};

/// The figure starts in its drawn pose, joints at rest, centre of mass at x = 0.
struct StartState {
  float drop_height_m = 0.0f;   // of the lowest endpoint above ground, [0, 100]
  float velocity_x_mps = 0.0f;  // of the centre of mass, [-100, 100]
  float velocity_y_mps = 0.0f;  // [-100, 100]
  float spin_radps = 0.0f;      // of the whole figure, anticlockwise, [-40, 40]
};

/// Pushes on the centre of mass name no endpoint.
inline constexpr int kCentreOfMass = -1;

/// An impulse at one instant.
struct Push {
  int step = 0;                  // just before this step, [0, kMaxSteps)
  int endpoint = kCentreOfMass;  // index of the endpoint it acts on
  float impulse_x_ns = 0.0f;     // N s, [-1e6, 1e6]
  float impulse_y_ns = 0.0f;

  bool operator==(const Push&) const = default;
};

}  // namespace gaitsmith
