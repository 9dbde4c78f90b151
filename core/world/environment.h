// SPDX-License-Identifier: MIT
// The world a figure moves in: ground, gravity, start state and pushes.
#pragma once

#include <vector>

#include "core/numeric/scalar_math.h"

namespace gaitsmith {

/// Standard gravity [m/s^2]. It scales the force senses, so that a controller can sense when a document
/// changes gravity.
inline constexpr float kStandardGravity = 9.8f;

/// Where two straight pieces of a drawn ground meet.
struct Corner {
  float x_m = 0.0f;  // along the ground, from where the centre of mass starts, [-200, 200]
  float y_m = 0.0f;  // [-20, 20]

  bool operator==(const Corner&) const = default;
};

/// The ground is the line y = 0 of a frame that tilts with it, so a slope is only a tilted gravity. This is
/// exact and avoids subtracting two large heights far from the origin. A drawn ground tilts with that line.
struct Environment {
  float gravity_mps2 = kStandardGravity;  // [0, 100]
  float friction = 0.8f;                  // Coulomb coefficient, [0, 10]
  float slope_rad = 0.0f;                 // uphill to the right, [-0.6, 0.6]
  float sway_rad = 0.0f;                  // amplitude of rocking about the slope, [0, 0.6]
  float sway_period_s = 4.0f;             // [0.5, 60]
  /// The ground's corners, from left to right (see terrain.h), at most kMaxCorners. None: level ground. From
  /// model 2 on.
  std::vector<Corner> ground = {};

  bool operator==(const Environment&) const = default;
};

/// The ground's angle [rad] at a time from the start [s]. The ground rocks like the deck of a ship far from
/// its pivot: only the direction of gravity changes. The acceleration of the ground itself is left out.
[[nodiscard]] inline float GroundAngle(const Environment& environment, float time_s) {
  if (environment.sway_rad == 0.0f) return environment.slope_rad;
  const float turns = time_s / environment.sway_period_s;
  const float part = turns - static_cast<float>(static_cast<int>(turns));
  return environment.slope_rad + environment.sway_rad * SinCos(2.0f * static_cast<float>(kPi) * part).sine;
}

/// The figure starts in its drawn pose with its joints at rest and its centre of mass at x = 0.
struct StartState {
  float drop_height_m = 0.0f;   // of the lowest endpoint above ground, [0, 100]
  float velocity_x_mps = 0.0f;  // of the centre of mass, [-100, 100]
  float velocity_y_mps = 0.0f;  // [-100, 100]
  float spin_radps = 0.0f;      // of the whole figure, counterclockwise, [-40, 40]
};

/// Push::endpoint of a push on the centre of mass.
inline constexpr int kCentreOfMass = -1;

/// An impulse at one instant.
struct Push {
  int step = 0;                  // the push acts just before this step, [0, kMaxSteps)
  int endpoint = kCentreOfMass;  // index of the endpoint it acts on, or kCentreOfMass
  float impulse_x_ns = 0.0f;     // N s, [-1e6, 1e6]
  float impulse_y_ns = 0.0f;

  bool operator==(const Push&) const = default;
};

}  // namespace gaitsmith
