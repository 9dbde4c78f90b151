// SPDX-License-Identifier: MIT
// The outline of a figure in a pose, as simple shapes that any canvas can paint.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "shell/body/figure_look.h"
#include "shell/body/figure_pose.h"

namespace gaitsmith::shell {

/// Two discs and the hull around them. One disc, if both ends are the same.
struct BodyPart {
  BodyPoint from, to;
  float from_m = 0.0f, to_m = 0.0f;  // radii
  float belly_m = 0.0f;              // by how much the radius swells halfway
  bool far = false;                  // on the far side
  int rod = 0;                       // or spring that it is drawn for; 0: the root
};

struct BodyEye {
  BodyPoint at;
  float radius_m = 0.0f;
};

/// In the order of drawing: far limbs first. The number of parts depends only on the figure.
/// @param endpoints in the skeleton's order, or nodes in the figure's
[[nodiscard]] std::vector<BodyPart> BodyPartsOf(const FigureLook&, std::span<const BodyPoint> endpoints);

/// The eye, if the figure has one. Drawn last.
[[nodiscard]] std::optional<BodyEye> EyeOf(const FigureLook&, std::span<const BodyPoint> endpoints);

}  // namespace gaitsmith::shell
