// SPDX-License-Identifier: MIT
// What a person asks of a figure in one word: a task with preset weights, and the test that says whether a
// motion did it. docs/style.md, "Goals", has the formulas and the evidence.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/document/document.h"

namespace gaitsmith {

enum class Goal { kFar, kHighJump, kCartwheel, kGlide, kCalm, kHeadUp };

/// Names on the command line and in tables, in the order of Goal.
inline constexpr auto kGoalNames =
    std::to_array<std::string_view>({"far", "high-jump", "cartwheel", "glide", "calm", "head-up"});
inline constexpr int kGoals = static_cast<int>(kGoalNames.size());

/// The strengths from which that of a figure was chosen: its goal's weights are those of GoalWeights times
/// one of these.
inline constexpr std::array<float, 6> kGoalStrengths = {1.0f, 2.0f, 3.0f, 4.0f, 8.0f, 16.0f};

/// A goal's weights at strength 1 for any figure, per unit of the term; at most 1000 at every strength.
[[nodiscard]] std::array<float, kStyleTerms> GoalWeights(Goal);
/// The strength of a goal for a figure, from the table of docs/studies/goals. A figure that was not measured
/// gets the middle one.
[[nodiscard]] float StrengthOf(Goal, std::string_view figure);

/// Sets kind and weights of the document's task. Keeps the duration, and what was shown with its weights.
void SetGoal(Goal, float strength, Document&);
/// As above, with the figure's own strength.
void SetGoal(Goal, Document&);
/// The goal whose task the document has; nothing if its weights are a person's own mix.
[[nodiscard]] std::optional<Goal> GoalOf(const Document&);

/// Whether a motion of the document did what the goal asks for, by fixed tests. Lengths are compared with the
/// figure's own size: the larger of width and height of the drawn pose.
/// @param terms of the whole motion @param seconds of the motion, above 0
[[nodiscard]] bool Meets(Goal, const Figure&, const Terms& terms, float seconds);

/// How many of twenty seeds met the goal with a shipped figure; nothing if it was not measured.
[[nodiscard]] std::optional<int> SeedsThatMeet(Goal, std::string_view figure);
inline constexpr int kGoalSeeds = 20;
/// A goal is offered if at least this many did.
inline constexpr int kSeedsToOffer = 16;

}  // namespace gaitsmith
