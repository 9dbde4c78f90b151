// SPDX-License-Identifier: MIT
// Carries out a document's plan: coarsely, so that there is soon something to see, then finely, then as the
// simulator plays it.
#pragma once

#include <array>
#include <functional>
#include <string_view>
#include <vector>

#include "core/planning/plan_playback.h"

namespace gaitsmith {

/// How a plan is getting on.
struct PlanReport {
  enum class Stage {
    kRelaxing,  // the solver is at work; the motion does not obey the laws yet
    kCoarse,    // a motion is found
    kFine,      // and refined
    kPlayed,    // and played: the document has a trajectory
    kRefused,   // no motion fulfils the plan; the document is as it was
  };
  Stage stage = Stage::kRelaxing;
  Document document;                  // with the motion in its plan
  int iterations = 0;                 // of the solver since the beginning
  double cost = 0.0;                  // of the motion
  std::vector<PlanMiss> misses = {};  // of a refused plan, the worst first; none: the solver gave up
  double played_miss_m = 0.0;         // see PlanPlayback
  double first_miss_m = 0.0;
  int corrections = 0;
};

/// Of PlanReport::Stage, in its order.
inline constexpr std::array<std::string_view, 5> kPlanStageNames = {"relaxing", "coarse", "fine", "played",
                                                                    "refused"};

/// Called for every iteration and every stage. Returns false to cancel: nothing more is reported then.
using PlanListener = std::function<bool(const PlanReport&)>;

/// Whether a plan can be carried out at all: it asks for something, the figure has joints, and the world is
/// one that plans know.
[[nodiscard]] Result<void> CanBePlanned(const Document&);

/// @param document can be planned. If it has a solved plan with the same stances, the solver starts there
/// @param fine     of the second stage
void CarryOutPlan(const Document& document, const PlanGrid& fine, const PlanListener&);

/// What is fine enough to show and to play.
inline constexpr PlanGrid kFinePlan{.degree = 5, .pieces_per_second = 32};

}  // namespace gaitsmith
