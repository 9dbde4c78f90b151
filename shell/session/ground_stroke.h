// SPDX-License-Identifier: MIT
// A ground after a person drew a line over a part of it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/world/environment.h"

namespace gaitsmith::shell {

/// The ground with the part under the line replaced by the line, in as few corners as show its shape. Steep
/// pieces become vertical. Left of the line the ground stays, with a vertical face where the line begins
/// higher or lower. Right of the line it stays, too; behind all corners it goes on level from the line's end.
/// @param ground  valid
/// @param drawn  in the order of drawing, from left to right or from right to left
/// @param detail_m  the line may be this far from what was drawn, and joins ground that is four times as near
/// @return a valid ground; nothing if the line is too short, or too many corners would remain
[[nodiscard]] std::optional<std::vector<Corner>> WithStroke(std::span<const Corner> ground,
                                                            std::span<const Corner> drawn, float detail_m);

/// The ground without corners on a straight line; no corners if it is level at 0.
[[nodiscard]] std::vector<Corner> WithoutNeedless(std::vector<Corner> ground);

/// A corner within the limits of a ground, in whole centimetres.
[[nodiscard]] Corner OnGrid(Corner);

}  // namespace gaitsmith::shell
