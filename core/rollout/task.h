// SPDX-License-Identifier: MIT
// What counts as a good motion: a primary term plus weighted secondary terms (style) [Fukunaga 1994,
// section 4.1].
#pragma once

#include <array>
#include <string_view>

#include "core/physics/terms.h"

namespace gaitsmith {

enum class TaskKind {
  kTravel,       // |distance| the centre of mass has moved, either way [m]
  kTravelRight,  // distance to the right [m]
  kTravelLeft,   // distance to the left [m]
  kJump,         // greatest height of the centre of mass above its start [m]
};

struct Task {
  TaskKind kind = TaskKind::kTravel;
  int duration_steps = 500;  // T in whole steps, [1, kMaxSteps]; the paper's motions: 5 to 10 s
  std::array<float, kStyleTerms> weights = {};  // of the secondary terms, [-1000, 1000]
};

/// Score of a motion that broke physics: worse than any real one.
inline constexpr float kVoidScore = -1e9f;

/// The primary term alone.
[[nodiscard]] float Primary(const Task&, const Terms&);

/// The further terms whose weights are not 0: what a search has to measure.
[[nodiscard]] FurtherTerms WeightedFurtherTerms(const Task&);

/// Fitness: primary term + sum of weight * secondary term; kVoidScore for a motion that broke physics or
/// whose fitness is not a number. Reads no further term whose weight is 0.
[[nodiscard]] float Fitness(const Task&, const Terms&);

/// "travel", "travel-right", "travel-left", "jump": names on the command line and in documents.
inline constexpr std::array<std::string_view, 4> kTaskNames = {"travel", "travel-right", "travel-left",
                                                               "jump"};

}  // namespace gaitsmith
