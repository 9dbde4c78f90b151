// SPDX-License-Identifier: MIT
// What an animator wants of a motion: where the figure is at some instants, and which endpoint stands when
// [Witkin 1988], [Cohen 1992]. Everything between is left to the laws of motion and to what costs least.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/numeric/error.h"
#include "core/physics/skeleton.h"
#include "core/world/environment.h"

namespace gaitsmith {

inline constexpr int kMaxKeyframes = 16;
inline constexpr int kMaxMarks = 8;  // of a keyframe
inline constexpr int kMaxStances = 64;
/// Longest motion that can be planned [steps].
inline constexpr int kMaxPlanSteps = 1000;
inline constexpr int kMaxPlanUnknowns = 20'000;

enum class MarkAxes { kBoth, kAlong, kUp };
inline constexpr std::array<std::string_view, 3> kMarkAxesNames = {"both", "along", "up"};

/// Where a point of the figure is to be.
struct Mark {
  int endpoint = kCentreOfMass;  // or an index in the skeleton's order
  MarkAxes axes = MarkAxes::kBoth;
  float x_m = 0.0f;  // along the ground, from where the centre of mass starts, [-200, 200]
  float y_m = 0.0f;  // above the line of the ground, [-20, 200]

  bool operator==(const Mark&) const = default;
};

struct Keyframe {
  int step = 0;  // [1, the plan's steps]
  /// Angles of all joints relative to the drawn ones [rad], in the skeleton's order. Empty: left open.
  std::vector<float> pose_rad = {};
  bool turned = false;    // whether turn_rad counts
  float turn_rad = 0.0f;  // how far the root rod has turned since the start, with whole turns, [-100, 100]
  std::vector<Mark> marks = {};
  bool still = false;  // nothing moves at this instant

  bool operator==(const Keyframe&) const = default;
};

/// An endpoint stands: it keeps its place on the ground, and the ground may push it. It lands at first_step
/// with an impulse, if that is not the start.
struct Stance {
  int endpoint = 0;    // in the skeleton's order
  int first_step = 0;  // [0, last_step)
  int last_step = 0;   // at most the plan's steps

  bool operator==(const Stance&) const = default;
};

/// A solved plan: the coefficients of its splines (plan_layout.h).
struct PlanSolution {
  int degree = 3;               // of positions, [3, 5]
  int pieces_per_second = 16;   // [2, 64]
  std::vector<float> unknowns;  // empty: not solved

  bool operator==(const PlanSolution&) const = default;
};

/// The motion begins as every motion of its document does: in the drawn pose, with the start's velocity.
struct Plan {
  int steps = 200;                  // of the motion, [2, kMaxPlanSteps]
  std::vector<Keyframe> keyframes;  // sorted by step
  std::vector<Stance> stances;      // of one endpoint: apart from each other
  /// What the squared angular acceleration of rods costs, against the squared torque of joints; both in units
  /// of mass, longest rod and gravity. [1e-6, 100]
  float smoothness = 0.1f;
  PlanSolution solved;

  /// Whether there is anything to plan.
  [[nodiscard]] bool Empty() const { return keyframes.empty() && stances.empty(); }

  bool operator==(const Plan&) const = default;
};

/// Checks every reference.
/// @return nothing, or the first fault: where it is ("plan.stances[1].endpoint") and what is wrong
[[nodiscard]] Result<void> Validate(const Plan&, const Skeleton&);

}  // namespace gaitsmith
