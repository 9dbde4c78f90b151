// SPDX-License-Identifier: MIT
// Grounds in words.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/world/ground_preset.h"

namespace gaitsmith::shell {

/// English, for Tr(), in the order of GroundPreset.
[[nodiscard]] const std::array<const char*, kGroundPresets>& GroundNames();

/// "Stairs", "Rubble 7". Nothing known: "Hand-drawn".
[[nodiscard]] std::string GroundWords(const std::optional<KnownGround>&);

}  // namespace gaitsmith::shell
