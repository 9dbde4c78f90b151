// SPDX-License-Identifier: MIT
#include "core/rollout/evaluation.h"

namespace gaitsmith {

void AddToMean(Evaluation& mean, const Evaluation& next, int before) {
  const float share = 1.0f / static_cast<float>(before + 1);
  const auto add = [&](float& value, float more) {
    value = before == 0 ? more : value + (more - value) * share;
  };
  const bool broken = (before > 0 && mean.terms.broke_physics) || next.terms.broke_physics;
  add(mean.terms.travel_m, next.terms.travel_m);
  add(mean.terms.start_height_m, next.terms.start_height_m);
  for (const StyleTermRow& term : kStyleTable) add(mean.terms.*term.value, next.terms.*term.value);
  for (std::size_t i = 0; i < kTraits; ++i) add(mean.traits[i], next.traits[i]);
  mean.terms.broke_physics = broken;
  const bool is_void = (before > 0 && mean.fitness <= kVoidScore) || next.fitness <= kVoidScore;
  add(mean.fitness, next.fitness);
  if (is_void) mean.fitness = kVoidScore;
}

}  // namespace gaitsmith
