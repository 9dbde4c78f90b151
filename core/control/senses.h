// SPDX-License-Identifier: MIT
// What a controller can sense: the physical senses of Table 1 [Fukunaga 1994], or the timer of its section
// 4.2, or the physical senses and a look at the ground ahead.
#pragma once

#include "core/signal/ports.h"
#include "core/signal/time.h"

namespace gaitsmith {

enum class SenseKind {
  kPhysical,  // joint angles, contact forces at the endpoints, height and vertical velocity of the centre of
              // mass
  kTimer,     // t' = t mod t_p, a wind-up toy
  kSight,     // the physical senses, the height of the ground ahead and the distance to its next corner
};

/// To which side a controller with sight looks, along the ground. Its mirror image looks to the other.
enum class Facing { kRight, kLeft };

/// What a trajectory does after its period.
enum class CurveEnd {
  kRepeat,  // starts again; its curves are closed
  kRest,    // rests at its last knot
};

/// A controller's senses, and the ranges that give its genes their meaning. sense_table.h lists every sense
/// with its range.
struct SenseSpec {
  SenseKind kind = SenseKind::kPhysical;
  int period_steps = 100;  // timer and trajectory only: t_p in whole steps, [2, kMaxSteps]
  // Time constants of responses are log-uniform in [tau_min_s, tau_max_s], both in [0.02, 10]. tau_min_s has
  // the strongest effect on style: below 0.07 figures leap, above 0.2 they only shuffle.
  float tau_min_s = 0.15f;
  float tau_max_s = 1.0f;
  float force_weights = 2.0f;  // force sensed as 1, in standard weights of the plant, [0.1, 100]
  float height_rods = 2.0f;    // height sensed as 1, in longest rods, [0.1, 100]
  float velocity_mps = 3.0f;   // vertical velocity sensed as 1, [0.1, 100]
  float sight_rods = 2.0f;     // with sight: how far it sees, in longest rods, [0.5, 20]
  Facing facing = Facing::kRight;
  CurveEnd at_end = CurveEnd::kRepeat;  // of a trajectory

  friend bool operator==(const SenseSpec&, const SenseSpec&) = default;
};

/// A timer's normalised value at a step of its period.
[[nodiscard]] inline float TimerSense(int phase, int period_steps) {
  return static_cast<float>(phase) / static_cast<float>(period_steps);
}

/// Physical stimulus intervals end within [kEdgeLow, kEdgeHigh] of the normalised sense. This range is wider
/// than [0, 1], because the sense of a foot in the air is exactly 0 most of the time, and an interval must be
/// able to contain 0 well inside its borders.
inline constexpr float kEdgeLow = -0.25f;
inline constexpr float kEdgeHigh = 1.25f;

/// The limits for the ends of stimulus intervals.
struct Edges {
  float low, high;
};
[[nodiscard]] constexpr Edges EdgesOf(SenseKind kind) {
  return kind == SenseKind::kTimer ? Edges{0.0f, 1.0f} : Edges{kEdgeLow, kEdgeHigh};
}

}  // namespace gaitsmith
