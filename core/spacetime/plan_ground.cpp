// SPDX-License-Identifier: MIT
#include "core/spacetime/plan_ground.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gaitsmith {

PlanGround::PlanGround(std::span<const Corner> ground, double length_m) {
  for (const Corner& corner : ground)
    corners_.push_back(
        {static_cast<double>(corner.x_m) / length_m, static_cast<double>(corner.y_m) / length_m});
}

PlanGround::Height PlanGround::At(double x) const {
  if (corners_.empty()) return {};
  const auto after = std::ranges::find_if(corners_, [x](const Point& corner) { return corner.x > x; });
  if (after == corners_.begin()) return {corners_.front().y};
  if (after == corners_.end()) return {corners_.back().y};
  const Point &from = *(after - 1), &to = *after;
  const double slope = (to.y - from.y) / (to.x - from.x);
  return {from.y + slope * (x - from.x), slope};
}

double PlanGround::CoefficientAt(double centre) const {
  const auto between = [this](double left, double right) {
    const double ends[] = {At(left).value, At(right).value};
    auto [low, high] = std::ranges::minmax(ends);
    for (const Point& corner : corners_) {
      if (corner.x < left || corner.x > right) continue;
      low = std::min(low, corner.y);
      high = std::max(high, corner.y);
    }
    return std::array{low, high};
  };
  // A point is within two grains of each coefficient that matters to it.
  const double highest = between(centre - 2.0 * kGrain, centre + 2.0 * kGrain)[1];
  const double lowest = between(centre - 4.0 * kGrain, centre + 4.0 * kGrain)[0];
  return highest + std::min(kSpare, highest - lowest);
}

PlanGround::Height PlanGround::CoverAt(double x) const {
  if (corners_.empty()) return {};
  const double place = x / kGrain, first = std::floor(place), s = place - first, r = 1.0 - s;
  const std::array<double, 4> value{r * r * r / 6.0, (4.0 - 6.0 * s * s + 3.0 * s * s * s) / 6.0,
                                    (4.0 - 6.0 * r * r + 3.0 * r * r * r) / 6.0, s * s * s / 6.0};
  const std::array<double, 4> slope{-0.5 * r * r, 1.5 * s * s - 2.0 * s, 2.0 * r - 1.5 * r * r, 0.5 * s * s};
  const std::array<double, 4> bend{r, 3.0 * s - 2.0, 3.0 * r - 2.0, s};
  Height cover;
  for (std::size_t i = 0; i < 4; ++i) {
    const double height = CoefficientAt((first - 1.0 + static_cast<double>(i)) * kGrain);
    cover.value += value[i] * height;
    cover.slope += slope[i] * height / kGrain;
    cover.bend += bend[i] * height / (kGrain * kGrain);
  }
  return cover;
}

}  // namespace gaitsmith
