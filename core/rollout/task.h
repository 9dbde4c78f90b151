// SPDX-License-Identifier: MIT
// The definition of a good motion: a primary term plus weighted secondary terms (style) [Fukunaga 1994,
// section 4.1].
#pragma once

#include <array>
#include <string_view>

#include "core/physics/terms.h"
#include "core/rollout/demonstration.h"

namespace gaitsmith {

enum class TaskKind {
  kTravel,       // |distance| moved by the centre of mass, in either direction [m]
  kTravelRight,  // distance to the right [m]
  kTravelLeft,   // distance to the left [m]
  kJump,         // greatest height of the centre of mass above its start [m]
};

/// Greatest weight of a secondary term, in both directions.
inline constexpr float kMaxStyleWeight = 1000.0f;

struct Task {
  TaskKind kind = TaskKind::kTravel;
  int duration_steps = 500;                     // T in whole steps, [1, kMaxSteps]; 5 to 10 s in the paper
  std::array<float, kStyleTerms> weights = {};  // of the secondary terms, [-kMaxStyleWeight, kMaxStyleWeight]
  Demonstration shown = {};                     // what the terms on_way and in_pose are measured against
};

/// Score of a motion that broke physics: worse than any real one.
inline constexpr float kVoidScore = -1e9f;

/// The primary term alone.
[[nodiscard]] float Primary(const Task&, const Terms&);

/// Whether the task says what a term is measured against: a way or a pose for on_way and in_pose. The other
/// terms need nothing.
[[nodiscard]] bool CanMeasure(const Task&, StyleTerm);

/// Takes away what was shown, and its weights.
void ForgetShown(Task&);

/// The further terms with a weight other than 0. A search has to measure these.
[[nodiscard]] FurtherTerms WeightedFurtherTerms(const Task&);

/// The fitness: primary term + sum of weight * secondary term. kVoidScore for a motion that broke physics or
/// whose fitness is not finite. Further terms with weight 0 are not read.
[[nodiscard]] float Fitness(const Task&, const Terms&);

/// Names on the command line and in documents.
inline constexpr std::array<std::string_view, 4> kTaskNames = {"travel", "travel-right", "travel-left",
                                                               "jump"};

}  // namespace gaitsmith
