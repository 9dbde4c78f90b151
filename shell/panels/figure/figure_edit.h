// SPDX-License-Identifier: MIT
// Edits of a figure: moving an endpoint, adding, removing or copying a rod, mirroring the whole. Core
// validates the result.
#pragma once

#include <imgui.h>

#include <span>

#include "core/physics/skeleton.h"

namespace gaitsmith::shell {

/// Points are the skeleton's endpoints [m], y upwards, in the same frame as `target`.
struct DrawnFigure {
  const Figure& figure;
  const Skeleton& skeleton;
  std::span<const ImVec2> points;
};

/// Turns and stretches the rod that ends at this endpoint. The rods attached to it keep their direction and
/// move with it.
[[nodiscard]] Figure WithEndpointAt(const DrawnFigure&, int endpoint, ImVec2 target);

/// Turns this rod and everything attached about the joint at its start. @param direction_rad of the rod,
/// counterclockwise from the right
[[nodiscard]] Figure WithLimbTurned(const DrawnFigure&, int limb, float direction_rad);

/// The nearest multiple of 15°.
[[nodiscard]] float SnappedAngle(float radians);
/// `to`, moved to a snapped direction and a multiple of 5 cm from `from`, at least 5 cm.
[[nodiscard]] ImVec2 Snapped(ImVec2 from, ImVec2 to);

/// A figure of one upright rod, to start a drawing.
[[nodiscard]] Figure SingleRod();
/// A figure of one rod from here to there [m], of 1 kg per metre.
[[nodiscard]] Figure RodBetween(ImVec2 from, ImVec2 to);

/// Adds a rod from this endpoint, with the figure's average mass per metre.
[[nodiscard]] Figure WithRodFrom(const DrawnFigure&, int endpoint, ImVec2 target);

/// Adds a rod of the same length at the far end of this rod, in a free direction.
/// @param rod index in Figure::rods
[[nodiscard]] Figure WithRodGrown(const Figure&, int rod);

/// Removes this rod and everything attached. @param rod index in Figure::rods, not the root
[[nodiscard]] Figure WithoutRod(const Figure&, int rod);

/// Copies a rod and everything attached, mirrored about the parent, so that a left leg yields a right one.
/// The copy is turned further if another rod is in the way. @param rod index in Figure::rods, not the root
[[nodiscard]] Figure WithLimbCopied(const Figure&, int rod);

/// Exchanges left and right, including joint limits.
[[nodiscard]] Figure Mirrored(const Figure&);

}  // namespace gaitsmith::shell
