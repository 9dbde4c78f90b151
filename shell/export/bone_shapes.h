// SPDX-License-Identifier: MIT
// The figure as the stage draws it, cut into shapes that move with its bones.
#pragma once

#include <array>
#include <vector>

#include "core/document/document.h"
#include "shell/body/body_parts.h"
#include "shell/export/picture_colours.h"

namespace gaitsmith::shell {

/// A convex shape, fixed to a bone.
struct BoneShape {
  int bone;
  const PictureColour* colour;
  /// Along the bone from its start and to the left of it [m], counterclockwise.
  std::vector<std::array<double, 2>> outline_m;
};

/// In the order of drawing: far limbs first, the eye last. Shapes of one bone often follow one another. None
/// of a figure of springs, whose shapes change.
[[nodiscard]] std::vector<BoneShape> BoneShapesOf(const Figure&);

/// Of a part where it is [m], counterclockwise. Empty, if that is no place: of a motion that fails.
[[nodiscard]] std::vector<std::array<double, 2>> OutlineOf(const BodyPart&);
[[nodiscard]] const PictureColour& ColourOf(const BodyPart&);

/// How far shapes reach below the endpoints on which the figure stands [m].
[[nodiscard]] double SoleM(const Figure&);

}  // namespace gaitsmith::shell
