// SPDX-License-Identifier: MIT
#include "core/breeding/taste_weights.h"

#include <algorithm>
#include <array>

namespace gaitsmith {

namespace {

/// Least log-odds of a plain difference in the primary term.
constexpr float kLeastPrimary = 0.5f;

/// The least weight that counts, in doubts: half-known weights help sooner than they mislead (tuned in
/// docs/studies/taste).
constexpr float kLeastWeight = 0.5f;

/// A style term's trait, and how much of the term one unit of the trait is.
struct Yardstick {
  Trait trait;
  float per_trait;
};

}  // namespace

std::array<float, kStyleTerms> WeightsOf(const Taste& taste, const Document& d) {
  const float size_m = SizeOf(d.figure);
  const float seconds = static_cast<float>(d.task.duration_steps) * kStep;
  const auto actuators = static_cast<float>(std::max(1, d.figure.Actuators()));
  const auto measures = std::to_array<Yardstick>({
      {Trait::kHeight, size_m},
      {Trait::kSlip, size_m * seconds},
      {Trait::kTurns, seconds},
      {Trait::kEffort, seconds * actuators},
      {Trait::kUpright, 1.0f},
      {Trait::kSmoothness, 1.0f},
      {Trait::kHeadHeight, size_m},
  });
  const auto worth = [&](const Yardstick& measure) {
    return TraitOf(taste.Weights(), measure.trait) /
           kTraitTable[static_cast<std::size_t>(measure.trait)].scale / measure.per_trait;
  };
  const bool jumps = d.task.kind == TaskKind::kJump;
  const Yardstick primary = {jumps ? Trait::kHeight : Trait::kSpeed, jumps ? size_m : size_m * seconds};
  const float least =
      kLeastPrimary / kTraitTable[static_cast<std::size_t>(primary.trait)].scale / primary.per_trait;
  float metre = worth(primary);
  if (d.task.kind == TaskKind::kTravelLeft) metre = -metre;
  if (d.task.kind == TaskKind::kTravel) metre = std::abs(metre);
  metre = std::max(metre, least);

  std::array<float, kStyleTerms> weights = d.task.weights;  // of what was shown: they stay
  for (std::size_t term = 0; term < measures.size(); ++term) {
    weights[term] = 0.0f;
    if (jumps && measures[term].trait == primary.trait) continue;  // it is the primary term
    const Trait trait = measures[term].trait;
    if (std::abs(TraitOf(taste.Weights(), trait)) > kLeastWeight * TraitOf(taste.Doubts(), trait))
      weights[term] = std::clamp(worth(measures[term]) / metre, -kMaxStyleWeight, kMaxStyleWeight);
  }
  return weights;
}

}  // namespace gaitsmith
