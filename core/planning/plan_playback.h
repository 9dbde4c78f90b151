// SPDX-License-Identifier: MIT
// A planned motion as the simulator plays it: open loop, as trajectories that know only the time. A plan's
// joints are exact and its ground is a constraint; the simulator's joints answer curves, and its feet may
// slip. So the figure misses its marks by some centimetres, and lands turned too far or not far enough. The
// plan is made again, with marks that are moved by as much. If that is not enough, several trajectories with
// more knots follow one another, and flights are corrected where they are decided, at their beginning; how
// the figure lands stays as it was planned.
#pragma once

#include "core/document/document.h"
#include "core/spacetime/planner.h"

namespace gaitsmith {

struct PlanPlayback {
  Document document;  // whose one controller is the trajectory; its plan is solved as it was asked for
  /// Greatest distance between the marks of keyframes and where the simulator has them. A turn that is
  /// missed, of a keyframe or at a landing, counts as the way of the longest rod's end.
  double miss_m = 0.0;
  double first_m = 0.0;  // the same before any correction
  int corrections = 0;
};

/// @param document its plan passes CheckScene, its figure has a joint
/// @param planned  a motion of its plan
/// @param watch    see SolvePlan. After it has returned false, the best that there is by then
[[nodiscard]] PlanPlayback PlayPlan(const Document& document, const PlannedMotion& planned,
                                    const PlanWatch& watch = {});

/// The document with the motion in its plan.
[[nodiscard]] Document WithSolution(const Document& document, const PlannedMotion& planned);

/// The motion of a document's solved plan. @param document its plan is solved
[[nodiscard]] PlannedMotion SolvedMotion(const Document& document);

}  // namespace gaitsmith
