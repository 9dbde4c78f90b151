// SPDX-License-Identifier: MIT
// Grounds that are chosen by name: steps, stairs, ramps, gaps, hurdles and rubble, to both sides alike.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/world/environment.h"

namespace gaitsmith {

enum class GroundPreset { kLevel, kStepUp, kStairs, kRamp, kGap, kHurdles, kRubble };

/// Names on the command line, in the order of GroundPreset.
inline constexpr auto kGroundPresetNames =
    std::to_array<std::string_view>({"level", "step", "stairs", "ramp", "gap", "hurdles", "rubble"});
inline constexpr int kGroundPresets = static_cast<int>(kGroundPresetNames.size());

/// All of them are level this far to the left and right of where the centre of mass starts [m]: every shipped
/// figure stands there.
inline constexpr float kLevelStart = 2.0f;

/// Seeds of rubble are 1 to this number.
inline constexpr int kMostRubble = 999;

/// The corners of a preset, valid for Validate; none for level ground.
/// @param seed  of rubble, any number; the same seed gives the same rubble everywhere
[[nodiscard]] std::vector<Corner> GroundOf(GroundPreset, std::uint32_t seed = 1);

/// A preset, and which rubble it is.
struct KnownGround {
  GroundPreset preset = GroundPreset::kLevel;
  std::uint32_t seed = 1;  // of rubble, [1, kMostRubble]

  bool operator==(const KnownGround&) const = default;
};

/// The preset that has these corners. Nothing if they were drawn by hand.
[[nodiscard]] std::optional<KnownGround> PresetOf(std::span<const Corner> ground);

}  // namespace gaitsmith
