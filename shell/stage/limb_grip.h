// SPDX-License-Identifier: MIT
// Turning a limb of a drawn figure by dragging it about its joint.
#pragma once

#include <imgui.h>

#include <vector>

#include "core/physics/skeleton.h"

namespace gaitsmith::shell {

/// A limb in hand.
struct LimbGrip {
  static constexpr int kNone = -1;
  int limb = kNone;       // index in the skeleton
  float grip_rad = 0.0f;  // angle from the limb to the grabbed point
};

/// Where the limb begins. @param points the figure's endpoints on the canvas
[[nodiscard]] ImVec2 StartOf(const Skeleton&, const std::vector<ImVec2>& points, int limb);
/// Direction of a limb on the canvas, counterclockwise from the right [rad].
[[nodiscard]] float DirectionOf(const Skeleton&, const std::vector<ImVec2>& points, int limb);

/// The nearest limb, from `first` on. Where limbs meet, the one whose middle is nearest to the pointer.
/// @param within distance [points]. @return LimbGrip::kNone if there is none
[[nodiscard]] int LimbAt(const Skeleton&, const std::vector<ImVec2>& points, ImVec2 pointer, float within,
                         int first = 1);

/// Takes a limb in hand. @param pivot that it turns about
[[nodiscard]] LimbGrip GripOf(const Skeleton&, const std::vector<ImVec2>& points, int limb, ImVec2 pivot,
                              ImVec2 pointer);
/// How far the limb in hand must turn to follow the pointer, the shorter way, so that a limb at one limit
/// does not flip to the other [rad].
[[nodiscard]] float TurnToward(const Skeleton&, const std::vector<ImVec2>& points, const LimbGrip&,
                               ImVec2 pivot, ImVec2 pointer);

/// Draws a joint's limits as an arc. @param angle_rad of the joint
void DrawReach(ImDrawList*, const Skeleton&, const std::vector<ImVec2>& points, int limb, float angle_rad,
               ImU32 colour);

}  // namespace gaitsmith::shell
