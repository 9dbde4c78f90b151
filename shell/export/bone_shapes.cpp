// SPDX-License-Identifier: MIT
// Outlines of the figure's parts, in the frames of their bones.
#include "shell/export/bone_shapes.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/numeric/scalar_math.h"

namespace gaitsmith::shell {

namespace {

using Points = std::vector<std::array<double, 2>>;

constexpr int kDirections = 32;  // of a round end: its outline is off by 0.5 % of its radius at most
constexpr int kBellySteps = 8;

double Turn(const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// The convex hull, counterclockwise [Andrew 1979].
Points HullOf(Points points) {
  std::ranges::sort(points);
  Points hull;
  for (const bool upper : {false, true}) {
    const std::size_t begin = hull.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto& point = points[upper ? points.size() - 1 - i : i];
      while (hull.size() > begin + 1 && Turn(hull[hull.size() - 2], hull.back(), point) <= 0.0)
        hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();  // is the first one of the other half
  }
  return hull;
}

/// Coordinates of a bone's start and direction.
class BoneFrame {
 public:
  BoneFrame(BodyPoint start, BodyPoint end) : start_(start) {
    const double x = static_cast<double>(end.x - start.x), y = static_cast<double>(end.y - start.y);
    const double length = std::sqrt(x * x + y * y);
    along_ = {x / length, y / length};
  }
  [[nodiscard]] std::array<double, 2> Of(BodyPoint point) const {
    const double x = static_cast<double>(point.x - start_.x), y = static_cast<double>(point.y - start_.y);
    return {x * along_[0] + y * along_[1], y * along_[0] - x * along_[1]};
  }

 private:
  BodyPoint start_;
  std::array<double, 2> along_{};
};

/// The hull of discs between two ends, whose radius swells halfway.
Points OutlineOf(const std::array<double, 2>& from, double from_m, const std::array<double, 2>& to,
                 double to_m, double belly_m) {
  const int discs = belly_m > 0.0 ? kBellySteps : 1;
  Points points;
  points.reserve(static_cast<std::size_t>(discs + 1) * kDirections);
  for (int disc = 0; disc <= discs; ++disc) {
    const double share = static_cast<double>(disc) / discs;
    const SineCosine half_turn = SinCos(static_cast<float>(share * kPi));
    const double radius = from_m + share * (to_m - from_m) + belly_m * static_cast<double>(half_turn.sine);
    for (int i = 0; i < kDirections; ++i) {
      const SineCosine way = SinCos(static_cast<float>(2.0 * kPi * i / kDirections));
      points.push_back({from[0] + share * (to[0] - from[0]) + radius * static_cast<double>(way.cosine),
                        from[1] + share * (to[1] - from[1]) + radius * static_cast<double>(way.sine)});
    }
  }
  return HullOf(std::move(points));
}

}  // namespace

std::vector<std::array<double, 2>> OutlineOf(const BodyPart& part) {
  for (const float number : {part.from.x, part.from.y, part.to.x, part.to.y, part.belly_m})
    if (!std::isfinite(number)) return {};
  const auto at = [](BodyPoint point) {
    return std::array{static_cast<double>(point.x), static_cast<double>(point.y)};
  };
  return OutlineOf(at(part.from), static_cast<double>(part.from_m), at(part.to),
                   static_cast<double>(part.to_m), static_cast<double>(part.belly_m));
}

const PictureColour& ColourOf(const BodyPart& part) { return part.far ? kFarColour : kInkColour; }

std::vector<BoneShape> BoneShapesOf(const Figure& figure) {
  if (figure.HasSprings()) return {};
  const Skeleton bones(figure);
  const FigureLook look = LookOf(figure);
  const std::vector<BodyPoint> endpoints = DrawnEndpoints(bones, {});
  const auto frame_of = [&](int bone) {
    const auto rod = static_cast<std::size_t>(bone);
    return BoneFrame(endpoints[static_cast<std::size_t>(bones.limbs[rod].start)], endpoints[rod + 1]);
  };
  std::vector<BoneShape> shapes;
  for (const BodyPart& part : BodyPartsOf(look, endpoints)) {
    const BoneFrame frame = frame_of(part.rod);
    shapes.push_back({part.rod, &ColourOf(part),
                      OutlineOf(frame.Of(part.from), static_cast<double>(part.from_m), frame.Of(part.to),
                                static_cast<double>(part.to_m), static_cast<double>(part.belly_m))});
  }
  if (const auto eye = EyeOf(look, endpoints)) {
    const auto at = frame_of(look.head_rod).Of(eye->at);
    const auto radius = static_cast<double>(eye->radius_m);
    shapes.push_back({look.head_rod, &kPaperColour, OutlineOf(at, radius, at, radius, 0.0)});
  }
  return shapes;
}

double SoleM(const Figure& figure) { return static_cast<double>(LookOf(figure).sole_m); }

}  // namespace gaitsmith::shell
