// SPDX-License-Identifier: MIT
// A figure as rounded rods with soft joints: on the stage, on rule cards, in the figure editor.
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

/// A thick line with round ends, without the seams that a line and two circles leave.
void DrawCapsule(ImDrawList*, ImVec2 from, ImVec2 to, float width, ImU32 colour);

/// An arrow with a light edge around it, so that it reads in front of the figure.
void DrawArrow(ImDrawList*, ImVec2 from, ImVec2 to, ImU32 colour, ImU32 edge);

/// The figure's endpoints in metres about its centre of mass, y upwards, for these joint angles
/// (skeleton.joints, or none for the drawn pose).
[[nodiscard]] std::vector<ImVec2> PoseOf(const Skeleton&, std::span<const float> angle_rad);

/// Anticlockwise from the right, y upwards [rad].
[[nodiscard]] float Direction(ImVec2 from, ImVec2 to);

/// Rod thickness that suits a figure drawn at this scale [points].
[[nodiscard]] float RodWidth(const Skeleton&, float points_per_metre);

}  // namespace gaitsmith::shell
