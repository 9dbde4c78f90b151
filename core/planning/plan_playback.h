// SPDX-License-Identifier: MIT
// A planned motion as the simulator plays it: open loop, as a trajectory that knows only the time. A plan's
// joints are exact and its ground is a constraint; the simulator's joints answer curves, and its feet may
// slip. So the figure misses its marks by some centimetres, and the plan is made again with marks that are
// moved by as much.
#pragma once

#include "core/document/document.h"
#include "core/spacetime/planner.h"

namespace gaitsmith {

struct PlanPlayback {
  Document document;     // whose one controller is the trajectory; its plan is solved as it was asked for
  double miss_m = 0.0;   // greatest distance between the marks of keyframes and where the simulator has them
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
