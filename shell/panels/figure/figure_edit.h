// SPDX-License-Identifier: MIT
// What drawing does to a figure: an endpoint moved, a rod grown, taken away or copied, all of it mirrored.
// Nothing here validates; core does.
#pragma once

#include <imgui.h>

#include <span>

#include "core/physics/skeleton.h"

namespace gaitsmith::shell {

/// Points are the skeleton's endpoints in metres, y upwards, in one frame with `target`.
struct DrawnFigure {
  const Figure& figure;
  const Skeleton& skeleton;
  std::span<const ImVec2> points;
};

/// Turns and stretches the rod that ends there. The rods that hang on it keep their direction and come along.
[[nodiscard]] Figure WithEndpointAt(const DrawnFigure&, int endpoint, ImVec2 target);

/// Turns this rod and all that hang on it about the joint where it begins. @param direction_rad of the rod,
/// anticlockwise from the right
[[nodiscard]] Figure WithLimbTurned(const DrawnFigure&, int limb, float direction_rad);

/// To the next 15°.
[[nodiscard]] float SnappedAngle(float radians);
/// `to`, in a snapped direction and a whole number of 5 cm from `from`, at least one.
[[nodiscard]] ImVec2 Snapped(ImVec2 from, ImVec2 to);

/// One upright rod to begin with.
[[nodiscard]] Figure SingleRod();

/// A new rod from this endpoint; as heavy per metre as the figure's average.
[[nodiscard]] Figure WithRodFrom(const DrawnFigure&, int endpoint, ImVec2 target);

/// The same without a hand: from the far end of this rod, as long as it, in a direction where there is room.
/// @param rod index in Figure::rods
[[nodiscard]] Figure WithRodGrown(const Figure&, int rod);

/// Without this rod and all that hang on it. @param rod index in Figure::rods, not the root
[[nodiscard]] Figure WithoutRod(const Figure&, int rod);

/// The rod and all that hang on it once more, mirrored about their parent: a left leg makes a right one.
/// Turned on a little where another rod stands there already. @param rod index in Figure::rods, not the root
[[nodiscard]] Figure WithLimbCopied(const Figure&, int rod);

/// Left and right exchanged, joint limits too.
[[nodiscard]] Figure Mirrored(const Figure&);

}  // namespace gaitsmith::shell
