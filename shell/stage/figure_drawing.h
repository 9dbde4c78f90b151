// SPDX-License-Identifier: MIT
// Draws a figure as rounded rods with marked joints, for the stage, the rule cards and the figure editor.
#pragma once

#include <imgui.h>

#include <span>
#include <vector>

#include "core/physics/skeleton.h"

namespace gaitsmith::shell {

struct FigureInk {
  ImU32 rods;
  ImU32 joints = 0;  // 0: joints are not marked
  float width;       // of the rods [points]
};

/// @param endpoints canvas positions in the skeleton's order
void DrawFigure(ImDrawList*, const Skeleton&, std::span<const ImVec2> endpoints, const FigureInk&);

/// A thick line with round ends, as one shape: a line and two circles would show seams.
void DrawCapsule(ImDrawList*, ImVec2 from, ImVec2 to, float width, ImU32 colour);

/// An arrow with an outline, so that it stands out from the figure.
void DrawArrow(ImDrawList*, ImVec2 from, ImVec2 to, ImU32 colour, ImU32 edge);

/// The figure's endpoints relative to its centre of mass [m], y upwards, for these joint angles: one per
/// joint, or none for the rest pose.
[[nodiscard]] std::vector<ImVec2> PoseOf(const Skeleton&, std::span<const float> angle_rad);

/// The direction of a vector, counterclockwise from the right, y upwards [rad].
[[nodiscard]] float Direction(ImVec2 from, ImVec2 to);

/// Rod thickness that suits a figure drawn at this scale [points].
[[nodiscard]] float RodWidth(const Skeleton&, float points_per_metre);

}  // namespace gaitsmith::shell
