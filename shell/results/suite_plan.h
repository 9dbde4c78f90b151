// SPDX-License-Identifier: MIT
// A suite: one search for each combination of senses, goal and style, to find different motions that can be
// chained.
#pragma once

#include <array>
#include <vector>

#include "core/document/document.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {

/// A style with one secondary term, in usual weights of the figure (UsualWeights).
struct SuiteStyle {
  const char* name;  // to be translated
  StyleTerm term;
  float units;  // 0: no secondary term
};
inline constexpr std::array<SuiteStyle, 5> kSuiteStyles = {{
    {TrLater("Plain"), StyleTerm::kSlipSum, 0.0f},
    {TrLater("Gliding: more slip"), StyleTerm::kSlipSum, 1.0f},
    {TrLater("Turning: more rotations"), StyleTerm::kRotations, 1.0f},
    {TrLater("High: centre of mass up"), StyleTerm::kMaxCmHeight, 1.0f},
    {TrLater("Lazy: less effort"), StyleTerm::kEffort, -1.0f},
}};
inline constexpr std::array<TaskKind, 3> kSuiteTasks = {TaskKind::kTravelRight, TaskKind::kTravelLeft,
                                                        TaskKind::kJump};
inline constexpr std::array<SenseKind, 2> kSuiteSenses = {SenseKind::kPhysical, SenseKind::kTimer};

struct SuiteChoice {
  std::array<bool, kSuiteSenses.size()> senses = {true, false};
  std::array<bool, kSuiteTasks.size()> tasks = {true, true, true};
  std::array<bool, kSuiteStyles.size()> styles = {true, false, true, false, false};

  [[nodiscard]] int Searches() const;
};

/// The searches, sorted by senses, then goal, then style. Figure, surroundings, duration and search settings
/// are the document's. A network has physical senses, so for a timer it is replaced by rules.
[[nodiscard]] std::vector<Document> SuiteOf(const Document&, const SuiteChoice&);

}  // namespace gaitsmith::shell
