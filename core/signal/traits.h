// SPDX-License-Identifier: MIT
// How a motion looks, in numbers: what the style terms measure, by second, and how the figure uses the
// ground. Lengths are in sizes of the figure, so that they mean the same for a flea and a giraffe. Searches
// that must keep motions apart compare these and know nothing else of physics.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace gaitsmith {

enum class Trait {
  kSpeed,
  kHeight,
  kSlip,
  kTurns,
  kEffort,
  kUpright,
  kSmoothness,
  kHeadHeight,
  kBounce,
  kAir,
  kSupport,
  kSteps,
  kStill,
};

struct TraitRow {
  std::string_view name;
  std::string_view unit;  // "" for a pure number
  float scale;            // a difference that everybody sees
};

/// In the order of Trait.
inline constexpr auto kTraitTable = std::to_array<TraitRow>({
    {"speed", "sizes/s", 1.0f},        // of the centre of mass, rightward positive
    {"height", "sizes", 0.5f},         // greatest height of the centre of mass above its start
    {"slip", "sizes/s", 1.0f},         // path of endpoints that bear load
    {"turns", "1/s", 0.25f},           // of the root rod, from start to end
    {"effort", "rad/s", 2.0f},         // mean over the joints of |change of angle|
    {"upright", "", 0.5f},             // mean cosine of the root rod's turn from the drawn pose
    {"smoothness", "rad/s^2", 40.0f},  // minus the mean of |change of a joint's rate|
    {"head_height", "sizes", 0.5f},    // mean
    {"bounce", "sizes", 0.15f},        // standard deviation of the centre's height
    {"air", "", 0.3f},                 // share of the time in which no endpoint bears load
    {"support", "", 0.3f},             // mean share of the endpoints that bear load
    {"steps", "1/s", 2.0f},            // touchdowns
    {"still", "", 0.3f},               // share of the time in which no joint turns and the centre rests
});
inline constexpr std::size_t kTraits = kTraitTable.size();

using Traits = std::array<float, kTraits>;

[[nodiscard]] inline float TraitOf(const Traits& traits, Trait trait) {
  return traits[static_cast<std::size_t>(trait)];
}

/// How different two motions look: 0 for the same, 1 if everything differs plainly. The root of the mean
/// square of the differences, each in scales and at most 1.
[[nodiscard]] inline float TraitDistance(const Traits& a, const Traits& b) {
  float sum = 0.0f;
  for (std::size_t i = 0; i < kTraits; ++i) {
    const float difference = std::min(1.0f, std::abs(a[i] - b[i]) / kTraitTable[i].scale);
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<float>(kTraits));
}

}  // namespace gaitsmith
