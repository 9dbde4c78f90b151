// SPDX-License-Identifier: MIT
// The figure of a motion as outlines, frame by frame, for pictures of pixels.
#pragma once

#include <array>
#include <vector>

#include "core/document/document.h"
#include "shell/export/bone_shapes.h"

namespace gaitsmith::shell {

class MovingOutlines {
 public:
  /// @param figure of the motion @param motion is kept as a reference
  MovingOutlines(const Figure& figure, const Motion& motion);

  struct Filled {
    const PictureColour* colour;
    std::vector<std::array<double, 2>> outline_m;  // along the ground and above it
  };
  /// In the order of drawing.
  [[nodiscard]] std::vector<Filled> At(int frame) const;

 private:
  const Motion& motion_;
  std::vector<BoneShape> shapes_;  // of rods
  FigureLook look_;                // of springs
};

}  // namespace gaitsmith::shell
