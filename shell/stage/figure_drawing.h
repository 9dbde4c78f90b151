// SPDX-License-Identifier: MIT
// Draws a figure: as a body around its rods, for people to look at, or as plain rods, to edit them.
#pragma once

#include <imgui.h>

#include <span>
#include <vector>

#include "core/physics/skeleton.h"
#include "shell/body/figure_look.h"
#include "shell/body/figure_pose.h"

namespace gaitsmith::shell {

/// How much of a body's colour its far limbs keep.
inline constexpr float kFarShare = 0.57f;

/// How hard the joints work: a limb is tinted by the strain of the joint where it starts, and has a ring at
/// its limit, so that it is seen without colours, too.
struct StrainInk {
  std::span<const float> strains = {};  // of each joint, [0, 1]; empty: nothing is tinted
  ImU32 tint = 0;                       // of a limb at its limit
  ImU32 gap = 0;                        // between a limb and its ring
  float limit = 1.0f;                   // strain from which there is a ring

  /// @param rod the root has no joint
  [[nodiscard]] float Of(int rod) const {
    return rod < 1 || strains.empty() ? 0.0f : strains[static_cast<std::size_t>(rod - 1)];
  }
};

/// Colours of a body; 0: that part is not drawn.
struct BodyInk {
  ImU32 body;
  ImU32 far = 0;     // limbs on the far side; 0: as the body
  ImU32 rods = 0;    // fine lines inside, where the rods are
  ImU32 joints = 0;  // dots
  ImU32 eye = 0;
  float grow = 0.0f;  // added to every radius [points]
  StrainInk strain = {};
};

/// A body drawn at this scale. Rods and joints are left out where they would only be specks.
/// @param endpoints canvas positions in the skeleton's order, or of nodes in the figure's
/// @param scale     points per metre
void DrawBody(ImDrawList*, const FigureLook&, std::span<const ImVec2> endpoints, float scale, const BodyInk&);

struct RodInk {
  ImU32 rods;
  ImU32 joints = 0;  // 0: joints are not marked
  float width;       // of the rods [points]
  StrainInk strain = {};
};

/// Rounded rods or springs of one width. @param endpoints as in DrawBody
void DrawRods(ImDrawList*, std::span<const Bar>, std::span<const ImVec2> endpoints, const RodInk&);
inline void DrawRods(ImDrawList* list, const Skeleton& skeleton, std::span<const ImVec2> endpoints,
                     const RodInk& ink) {
  DrawRods(list, BarsOf(skeleton), endpoints, ink);
}

/// A limb: two discs and the hull around them, as one shape.
void DrawLimb(ImDrawList*, ImVec2 from, float from_radius, ImVec2 to, float to_radius, ImU32 colour);

/// A thick line with round ends, as one shape: a line and two circles would show seams.
void DrawCapsule(ImDrawList*, ImVec2 from, ImVec2 to, float width, ImU32 colour);

/// An arrow with an outline, so that it stands out from the figure.
void DrawArrow(ImDrawList*, ImVec2 from, ImVec2 to, ImU32 colour, ImU32 edge);

/// The points of EndpointsOf, as the canvas takes them.
[[nodiscard]] std::vector<ImVec2> PoseOf(const Skeleton&, std::span<const float> angle_rad);
/// In the drawn pose.
[[nodiscard]] std::vector<ImVec2> PoseOf(const Figure&);

/// How far a point is from the line between two others, and from its ends.
[[nodiscard]] float DistanceToLine(ImVec2 point, ImVec2 from, ImVec2 to);

/// The direction of a vector, counterclockwise from the right, y upwards [rad].
[[nodiscard]] float Direction(ImVec2 from, ImVec2 to);

/// Rod thickness that suits a figure drawn at this scale [points].
[[nodiscard]] float RodWidth(const Skeleton&, float points_per_metre);
/// The same, also for springs.
[[nodiscard]] float RodWidth(const Figure&, float points_per_metre);

}  // namespace gaitsmith::shell
