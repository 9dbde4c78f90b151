// SPDX-License-Identifier: MIT
// Finds the motion that fulfils a plan and costs least, or says what of the plan cannot be met.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/spacetime/plan_miss.h"
#include "core/spacetime/planned_motion.h"

namespace gaitsmith {

/// Checks what Validate cannot: that the world is one that plans know, and that endpoints that stand from the
/// start do so in the drawn pose.
[[nodiscard]] Result<void> CheckScene(const PlanScene&);

struct PlanAnswer {
  std::optional<PlannedMotion> motion;  // none if the plan cannot be met, or if it was cancelled
  std::vector<PlanMiss> misses;         // what cannot be met, the worst first [m or rad]
  bool cancelled = false;
  int iterations = 0;
  double cost = 0.0;  // what the motion minimises (transcription.h)
};

/// The motion as it is before an iteration. Returns false to cancel.
using PlanWatch = std::function<bool(const PlannedMotion&, int iteration)>;

/// @param scene passes CheckScene
/// @param from  a motion to start from, of a plan that has the same stances; null: a guess
[[nodiscard]] PlanAnswer SolvePlan(const PlanScene& scene, const PlanGrid&,
                                   const PlannedMotion* from = nullptr, const PlanWatch& watch = {});

}  // namespace gaitsmith
