// SPDX-License-Identifier: MIT
// What a controller can feel: the physical senses of Table 1 [Fukunaga 1994], or the timer of its
// section 4.2.
#pragma once

#include <string>

#include "core/physics/constants.h"

namespace gaitsmith {

enum class SenseKind {
  kPhysical,  // joint angles, contact forces at the endpoints, height and vertical velocity of the centre of
              // mass
  kTimer,     // t' = t mod t_p, a wind-up toy
};

/// Most values a controller can sense: joints + endpoints + 2.
inline constexpr int kMaxSenses = kMaxJoints + kMaxEndpoints + 2;

/// A controller's senses and the ranges that give its genes their meaning. Senses are normalised:
///   joint angle       its limits                            -> [0, 1]
///   contact force     [0, force_weights * weight]           -> [0, 1], clipped (impacts spike to 35 weights)
///   height of c.o.m.  [0, height_rods * longest rod]        -> [0, 1]
///   vertical velocity [-velocity_mps, velocity_mps]         -> [0, 1]
///   timer             [0, period)                           -> [0, 1)
struct SenseSpec {
  SenseKind kind = SenseKind::kPhysical;
  int period_steps = 100;  // t_p in whole steps, [2, kMaxSteps]; used by the timer
  float tau_min_s =
      0.15f;  // time constants of responses, log-uniform, [0.02, 10]; the least one is the master
  float tau_max_s = 1.0f;      // knob of style: below 0.07 figures leap, above 0.2 they only shuffle
  float force_weights = 2.0f;  // [0.1, 100]
  float height_rods = 2.0f;    // [0.1, 100]
  float velocity_mps = 3.0f;   // [0.1, 100]

  friend bool operator==(const SenseSpec&, const SenseSpec&) = default;
};

/// What a timer shows at a step of its period.
[[nodiscard]] inline float TimerSense(int phase, int period_steps) {
  return static_cast<float>(phase) / static_cast<float>(period_steps);
}

/// Physical stimulus intervals end within [kEdgeLow, kEdgeHigh] of the normalised sense: wider than [0, 1],
/// because a foot in the air feels exactly 0 most of the time and an interval must be able to hold that well
/// inside.
inline constexpr float kEdgeLow = -0.25f;
inline constexpr float kEdgeHigh = 1.25f;

/// Where the ends of stimulus intervals may lie.
struct Edges {
  float low, high;
};
[[nodiscard]] constexpr Edges EdgesOf(SenseKind kind) {
  return kind == SenseKind::kTimer ? Edges{0.0f, 1.0f} : Edges{kEdgeLow, kEdgeHigh};
}

/// Values in the sense vector of a figure with this many rods: 2 n + 2 physical, 1 timer.
[[nodiscard]] int SenseCount(SenseKind kind, int rods);

/// "angle 1", "force 3", "height", "rise", "timer". Joints and endpoints count from 1 as in the paper.
[[nodiscard]] std::string SenseName(SenseKind kind, int rods, int sense);

}  // namespace gaitsmith
