// SPDX-License-Identifier: MIT
// Pictures of the figure's parts, side by side in one picture, for programs that move pictures with bones.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "shell/export/bone_shapes.h"

namespace gaitsmith::shell {

class PartAtlas {
 public:
  /// A part's place in the picture, and where its middle is on its bone, with y to the right of it [px].
  struct Region {
    int x = 0, y = 0, width = 0, height = 0;
    std::array<double, 2> middle{};
    std::vector<std::array<double, 2>> outline;  // within the region
  };

  /// @param shapes are kept as a reference
  explicit PartAtlas(const std::vector<BoneShape>& shapes);

  /// 100 pixels a metre, fewer if a part would be longer than 1000.
  [[nodiscard]] double Scale() const { return scale_; }
  [[nodiscard]] int Width() const { return width_; }
  [[nodiscard]] int Height() const { return height_; }
  /// Of the shapes, in their order.
  [[nodiscard]] const std::vector<Region>& Regions() const { return regions_; }
  /// The picture as a PNG, in the colours of the light theme.
  [[nodiscard]] std::string Png() const;

 private:
  [[nodiscard]] Region RegionOf(const BoneShape& shape) const;
  void Pack();

  const std::vector<BoneShape>& shapes_;
  double scale_;
  std::vector<Region> regions_;
  int width_ = 0, height_ = 0;
};

}  // namespace gaitsmith::shell
