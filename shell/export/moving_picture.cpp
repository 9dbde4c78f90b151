// SPDX-License-Identifier: MIT
// Scale, view and ground of a picture that moves.
#include "shell/export/moving_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/numeric/scalar_math.h"
#include "core/world/ground_view.h"
#include "shell/export/film_strip_layout.h"

namespace gaitsmith::shell {

namespace {

constexpr double kTopY = 62.0;       // of the figure at its highest [px]
constexpr double kMostWide = 250.0;  // of the figure [px]
constexpr double kLeastTickPx = 76.0;
// A motion that fails must not shrink its figure to nothing [m], [widths].
constexpr double kWidest = 1000.0, kHighest = 50.0;
constexpr double kMostMarks = 400.0;  // then they are further apart
constexpr double kKeyPx = 0.2, kKeyDegrees = kKeyAngleRad * 180.0 / kPi;

}  // namespace

MovingPicture::MovingPicture(const Document& document, const Motion& motion, bool loops)
    : bones_(motion),
      ground_(document.environment.ground),
      view_(motion, ground_, loops),
      loops_(loops),
      sole_m_(SoleM(document.figure)),
      shapes_(BoneShapesOf(document.figure)) {
  double widest = 0.0, top = 0.0;
  for (int frame = 0; frame < motion.Frames(); ++frame) {
    const Motion::Frame& at = motion.At(frame);
    const double level = HeightBelow(ground_, at.x_m);
    double left = 1e300, right = -1e300;
    for (int k = 0; k < motion.Connections().contacts; ++k) {
      const Motion::Point point = motion.Endpoint(frame, k);
      left = std::min(left, static_cast<double>(point.x));
      right = std::max(right, static_cast<double>(point.x));
      top = std::max(top, static_cast<double>(at.y_m) + static_cast<double>(point.y) - level);
    }
    widest = std::max(widest, right - left);
  }
  widest = std::clamp(widest, 1e-6, kWidest);
  const double high = std::min(top, kHighest * widest) + 2.0 * sole_m_;
  scale_ = std::min(kMostWide / widest, (kGroundY - kTopY) / std::max(high, 1e-6));
  for (BoneShape& shape : shapes_) {
    for (auto& [x, y] : shape.outline_m) {
      x *= scale_;
      y *= -scale_;
    }
  }
  const double way = view_.WayM();
  tick_m_ = RoundLength(scale_, kLeastTickPx);
  if (loops && std::abs(way) > 1e-6) {
    // Marks of a loop are where they were a cycle before. A way too short for that has none.
    const double marks = std::floor(std::abs(way) / tick_m_ + 0.5);
    tick_m_ = marks > 0.0 ? std::abs(way) / marks : 0.0;
  } else {
    const auto [left, right] = Reach();
    tick_m_ = std::max(tick_m_, RoundLength(1.0, (right - left) / kMostMarks));
  }
}

std::array<double, 2> MovingPicture::PlaceAt(int frame, const std::array<double, 2>& place_m) const {
  return {0.5 * kWidth + (place_m[0] - view_.MiddleM(frame)) * scale_,
          kGroundY - sole_m_ * scale_ - (place_m[1] - view_.GroundM(frame)) * scale_};
}

std::array<double, 2> MovingPicture::GroundAt(int frame) const {
  return {0.5 * kWidth - (view_.MiddleM(frame) - view_.MiddleM(0)) * scale_,
          kGroundY + view_.GroundM(frame) * scale_};
}

Track MovingPicture::PlaceKeys() const {
  std::vector<std::array<double, 2>> places;
  places.reserve(static_cast<std::size_t>(view_.Frames()));
  for (int frame = 0; frame < view_.Frames(); ++frame) places.push_back(PlaceAt(frame, bones_.Start(frame)));
  return KeysOf(places, kKeyPx);
}

Track MovingPicture::AngleKeys(int bone) const {
  std::vector<std::array<double, 2>> angles;
  angles.reserve(static_cast<std::size_t>(view_.Frames()));
  for (int frame = 0; frame < bones_.Frames(); ++frame)
    angles.push_back({-bones_.AngleRad(frame, bone) * 180.0 / kPi, 0.0});
  return KeysOf(angles, kKeyDegrees);
}

Track MovingPicture::GroundKeys() const {
  std::vector<std::array<double, 2>> places;
  places.reserve(static_cast<std::size_t>(view_.Frames()));
  for (int frame = 0; frame < view_.Frames(); ++frame) places.push_back(GroundAt(frame));
  return KeysOf(places, kKeyPx);
}

std::array<double, 2> MovingPicture::Reach() const {
  const double half = 0.5 * kWidth / scale_ + tick_m_;
  return {view_.LeastM() - half, view_.MostM() + half};
}

std::vector<std::array<double, 2>> MovingPicture::Surface() const {
  const auto [left, right] = Reach();
  const auto point = [&](double x_m, double y_m) {
    return std::array{(x_m - view_.MiddleM(0)) * scale_, -y_m * scale_};
  };
  std::vector<std::array<double, 2>> line{point(left, HeightBelow(ground_, left))};
  if (!ground_.Level()) {
    for (const Terrain::Face& face : ground_.FacesBetween(left, right))
      if (face.x > left) line.push_back(point(face.x, face.y));
  }
  line.push_back(point(right, HeightBelow(ground_, right)));
  return line;
}

double MovingPicture::Bottom() const {
  double lowest = 0.0;
  for (const auto& point : Surface()) lowest = std::max(lowest, point[1]);
  return lowest + kHeight;
}

std::vector<MovingPicture::Mark> MovingPicture::Marks() const {
  const auto [left, right] = Reach();
  std::vector<Mark> marks;
  if (tick_m_ == 0.0) return marks;
  for (double mark = std::ceil(left / tick_m_);
       mark * tick_m_ <= right && static_cast<double>(marks.size()) < 2.0 * kMostMarks; mark += 1.0) {
    const double x = mark * tick_m_;
    char text[40];
    std::snprintf(text, sizeof text, "%s%.*f m", mark < 0.0 ? "−" : "",
                  tick_m_ < 0.095  ? 2
                  : tick_m_ < 0.95 ? 1
                                   : 0,
                  std::abs(x));
    marks.push_back({(x - view_.MiddleM(0)) * scale_, -HeightBelow(ground_, x) * scale_, loops_ ? "" : text});
  }
  return marks;
}

}  // namespace gaitsmith::shell
