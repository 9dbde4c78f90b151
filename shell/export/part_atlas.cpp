// SPDX-License-Identifier: MIT
// Cuts and packs the parts.
#include "shell/export/part_atlas.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "shell/export/painted_picture.h"
#include "shell/export/picture_colours.h"

namespace gaitsmith::shell {

namespace {

constexpr double kUsualScale = 100.0;    // as Godot's scenes have it [px/m]
constexpr double kLongestPart = 1000.0;  // [px]
constexpr int kPartMargin = 1;           // around a part [px]

double ScaleOf(const std::vector<BoneShape>& shapes) {
  double longest_m = 0.0;
  for (const BoneShape& shape : shapes) {
    const auto [left, right] = std::ranges::minmax_element(shape.outline_m);
    longest_m = std::max(longest_m, (*right)[0] - (*left)[0]);
  }
  return std::min(kUsualScale, kLongestPart / std::max(longest_m, 1e-6));
}

}  // namespace

PartAtlas::PartAtlas(const std::vector<BoneShape>& shapes) : shapes_(shapes), scale_(ScaleOf(shapes)) {
  regions_.reserve(shapes.size());
  for (const BoneShape& shape : shapes_) regions_.push_back(RegionOf(shape));
  Pack();
}

std::string PartAtlas::Png() const {
  PaintedPicture picture(width_, height_);
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    auto outline = regions_[i].outline;
    for (auto& [x, y] : outline) {
      x += regions_[i].x;
      y += regions_[i].y;
    }
    picture.Fill(outline, shapes_[i].colour->light);
  }
  return PngOf(picture);
}

PartAtlas::Region PartAtlas::RegionOf(const BoneShape& shape) const {
  double left = 1e300, right = -1e300, top = 1e300, bottom = -1e300;
  for (const auto& [x, y] : shape.outline_m) {
    left = std::min(left, x * scale_);
    right = std::max(right, x * scale_);
    top = std::min(top, -y * scale_);
    bottom = std::max(bottom, -y * scale_);
  }
  Region region;
  region.width = static_cast<int>(std::ceil(right - left)) + 2 * kPartMargin;
  region.height = static_cast<int>(std::ceil(bottom - top)) + 2 * kPartMargin;
  region.middle = {left - kPartMargin + 0.5 * region.width, top - kPartMargin + 0.5 * region.height};
  for (const auto& [x, y] : shape.outline_m)
    region.outline.push_back({x * scale_ - left + kPartMargin, -y * scale_ - top + kPartMargin});
  return region;
}

// Puts the parts in rows, the highest first.
void PartAtlas::Pack() {
  std::vector<std::size_t> order(regions_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    return regions_[a].height != regions_[b].height ? regions_[a].height > regions_[b].height : a < b;
  });
  double area = 0.0;
  int widest = 0;
  for (const Region& region : regions_) {
    area += static_cast<double>(region.width) * region.height;
    widest = std::max(widest, region.width);
  }
  const int row_width = std::max(widest, static_cast<int>(std::ceil(std::sqrt(1.3 * area))));
  int x = 0, y = 0, row = 0;
  for (const std::size_t i : order) {
    Region& region = regions_[i];
    if (x > 0 && x + region.width > row_width) {
      y += row;
      x = row = 0;
    }
    region.x = x;
    region.y = y;
    x += region.width;
    row = std::max(row, region.height);
    width_ = std::max(width_, x);
  }
  height_ = y + row;
}

}  // namespace gaitsmith::shell
