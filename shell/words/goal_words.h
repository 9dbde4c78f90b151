// SPDX-License-Identifier: MIT
// The goals in words.
#pragma once

#include <array>
#include <string>

#include "core/document/goals.h"

namespace gaitsmith::shell {

/// English, for Tr().
struct GoalWords {
  const char* label;  // "High jump"
  const char* line;   // "Gets its body as high as it can."
  const char* teach;  // "Teach it to jump"; null: by the figure's way of moving
};

/// In the order of Goal.
[[nodiscard]] const std::array<GoalWords, kGoals>& GoalTexts();
[[nodiscard]] const GoalWords& WordsOf(Goal);

/// Whether the page offers a goal for a figure. Figures that were not measured may try every goal.
[[nodiscard]] bool Offers(Goal, std::string_view figure);
/// Why a goal is not offered: "Only 3 of 20 tries managed this."
[[nodiscard]] std::string WhyNotOffered(Goal, std::string_view figure);

}  // namespace gaitsmith::shell
