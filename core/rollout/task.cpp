// SPDX-License-Identifier: MIT
#include "core/rollout/task.h"

#include <cmath>

namespace gaitsmith {

float Primary(const Task& task, const Terms& terms) {
  switch (task.kind) {
    case TaskKind::kTravel:
      return std::abs(terms.travel_m);
    case TaskKind::kTravelRight:
      return terms.travel_m;
    case TaskKind::kTravelLeft:
      return -terms.travel_m;
    case TaskKind::kJump:
      return terms.max_cm_height_m - terms.start_height_m;
  }
  return kVoidScore;
}

bool CanMeasure(const Task& task, StyleTerm term) {
  if (term == StyleTerm::kOnWay) return !task.shown.way.empty();
  return term != StyleTerm::kInPose || !task.shown.pose_rad.empty();
}

void ForgetShown(Task& task) {
  task.shown = {};
  for (std::size_t term = kFreeTerms; term < kWorkTerms; ++term) task.weights[term] = 0.0f;
}

FurtherTerms WeightedFurtherTerms(const Task& task) {
  FurtherTerms weighted{};
  for (std::size_t i = 0; i < weighted.size(); ++i) weighted[i] = task.weights[kPaperTerms + i] != 0.0f;
  return weighted;
}

float Fitness(const Task& task, const Terms& terms) {
  if (terms.broke_physics) return kVoidScore;
  float fitness = Primary(task, terms);
  for (int term = 0; term < kStyleTerms; ++term) {
    const float weight = task.weights[static_cast<std::size_t>(term)];
    if (term >= kPaperTerms && weight == 0.0f) continue;  // not measured
    fitness += weight * terms.Style(static_cast<StyleTerm>(term));
  }
  return std::isfinite(fitness) ? fitness : kVoidScore;
}

}  // namespace gaitsmith
