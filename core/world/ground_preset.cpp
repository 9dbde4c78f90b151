// SPDX-License-Identifier: MIT
#include "core/world/ground_preset.h"

#include <algorithm>

#include "core/numeric/random.h"
#include "core/world/terrain.h"

namespace gaitsmith {

namespace {

/// A corner in whole centimetres, so that links and files stay short and floats are the same everywhere.
Corner At(int x_cm, int y_cm) {
  return {static_cast<float>(x_cm) / 100.0f, static_cast<float>(y_cm) / 100.0f};
}

constexpr int kStartCm = static_cast<int>(kLevelStart * 100.0f);

/// The same to the left. Way counts in both directions, so an obstacle on one side would be walked away from.
std::vector<Corner> BothWays(const std::vector<Corner>& right) {
  std::vector<Corner> ground;
  ground.reserve(2 * right.size());
  for (auto corner = right.rbegin(); corner != right.rend(); ++corner)
    ground.push_back({-corner->x_m, corner->y_m});
  ground.insert(ground.end(), right.begin(), right.end());
  return ground;
}

/// Stairs as a person would build them, up and down again.
std::vector<Corner> Stairs() {
  constexpr int kSteps = 7, kRiseCm = 15, kTreadCm = 50, kLandingCm = 200;
  std::vector<Corner> ground;
  int x = kStartCm, y = 0;
  for (int step = 0; step < kSteps; ++step) {
    ground.push_back(At(x, y));
    ground.push_back(At(x, y += kRiseCm));
    x += step + 1 < kSteps ? kTreadCm : kLandingCm;
  }
  for (int step = 0; step < kSteps; ++step) {
    ground.push_back(At(x, y));
    ground.push_back(At(x, y -= kRiseCm));
    x += kTreadCm;
  }
  return ground;
}

std::vector<Corner> Hurdles() {
  constexpr int kHurdles = 7, kApartCm = 250, kHighCm = 20, kThickCm = 10;
  std::vector<Corner> ground;
  for (int hurdle = 0; hurdle < kHurdles; ++hurdle) {
    const int x = kStartCm + hurdle * kApartCm;
    for (const Corner& corner : {At(x, 0), At(x, kHighCm), At(x + kThickCm, kHighCm), At(x + kThickCm, 0)})
      ground.push_back(corner);
  }
  return ground;
}

/// Rubble between two places, both of which are at height 0. About one stretch in three ends at a vertical
/// face.
/// @param stretches  at least 2; makes `stretches` + 1 corners, and one more for each face
/// @param faces  the most vertical faces
void AddRubble(RandomStream& random, int from_cm, int to_cm, int stretches, int faces,
               std::vector<Corner>& ground) {
  constexpr std::uint32_t kHighestCm = 15;
  constexpr int kLeastFaceCm = 3;
  const int mean = (to_cm - from_cm) / stretches;
  ground.push_back(At(from_cm, 0));
  int height = 0;
  for (int stretch = 1; stretch < stretches; ++stretch) {
    const int wander = static_cast<int>(random.Below(static_cast<std::uint32_t>(mean / 2 + 1))) - mean / 4;
    const int x = from_cm + stretch * mean + wander;
    const auto next = static_cast<int>(random.Below(kHighestCm + 1));
    const int rise = next > height ? next - height : height - next;
    if (random.Below(3) == 0 && rise >= kLeastFaceCm && faces > 0) {
      ground.push_back(At(x, height));
      --faces;
    }
    ground.push_back(At(x, next));
    height = next;
  }
  ground.push_back(At(to_cm, 0));
}

constexpr int kRubbleEndCm = 2200;

std::vector<Corner> Rubble(std::uint32_t seed) {
  // A few corners less than the most, so that a person can add some.
  constexpr int kStretches = 21, kFaces = 8;
  static_assert(2 * (kStretches + 1 + kFaces) < kMaxCorners);
  RandomStream random(seed, 0, 0);
  std::vector<Corner> ground;
  AddRubble(random, -kRubbleEndCm, -kStartCm, kStretches, kFaces, ground);
  AddRubble(random, kStartCm, kRubbleEndCm, kStretches, kFaces, ground);
  return ground;
}

}  // namespace

std::vector<Corner> GroundOf(GroundPreset preset, std::uint32_t seed) {
  switch (preset) {
    case GroundPreset::kLevel:
      return {};
    case GroundPreset::kStepUp:
      return BothWays({At(kStartCm, 0), At(kStartCm, 30)});
    case GroundPreset::kStairs:
      return BothWays(Stairs());
    case GroundPreset::kRamp:
      // One in five, up and down again.
      return BothWays(
          {At(kStartCm, 0), At(kStartCm + 500, 100), At(kStartCm + 800, 100), At(kStartCm + 1300, 0)});
    case GroundPreset::kGap:
      return BothWays({At(kStartCm, 0), At(kStartCm, -100), At(kStartCm + 50, -100), At(kStartCm + 50, 0)});
    case GroundPreset::kHurdles:
      return BothWays(Hurdles());
    case GroundPreset::kRubble:
      return Rubble(seed);
  }
  return {};
}

std::optional<KnownGround> PresetOf(std::span<const Corner> ground) {
  for (int i = 0; i < kGroundPresets; ++i) {
    const auto preset = static_cast<GroundPreset>(i);
    if (preset != GroundPreset::kRubble && std::ranges::equal(GroundOf(preset), ground))
      return KnownGround{preset};
  }
  // All rubble begins at one place, so that a ground drawn by hand is not compared with each.
  if (ground.empty() || ground.front() != At(-kRubbleEndCm, 0)) return std::nullopt;
  for (std::uint32_t seed = 1; seed <= kMostRubble; ++seed) {
    if (std::ranges::equal(Rubble(seed), ground)) return KnownGround{GroundPreset::kRubble, seed};
  }
  return std::nullopt;
}

}  // namespace gaitsmith
