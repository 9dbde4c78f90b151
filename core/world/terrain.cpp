// SPDX-License-Identifier: MIT
#include "core/world/terrain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace gaitsmith {

namespace {

constexpr double kFarAway = 1e7;  // [m], beyond what any motion reaches

std::string NameOf(std::size_t corner, const char* field) {
  std::string name = "ground[" + std::to_string(corner) + "].";
  return name.append(field);
}

}  // namespace

Result<void> Validate(std::span<const Corner> ground) {
  if (ground.size() > kMaxCorners) {
    return Fail(
        ErrorCode::kTooMany, "ground",
        "at most " + std::to_string(kMaxCorners) + " corners, there are " + std::to_string(ground.size()));
  }
  for (std::size_t i = 0; i < ground.size(); ++i) {
    const Corner& corner = ground[i];
    if (!std::isfinite(corner.x_m) || std::abs(corner.x_m) > kMaxCornerX)
      return Fail(ErrorCode::kOutOfRange, NameOf(i, "x_m"), "must be from -200 to 200");
    if (!std::isfinite(corner.y_m) || std::abs(corner.y_m) > kMaxCornerY)
      return Fail(ErrorCode::kOutOfRange, NameOf(i, "y_m"), "must be from -20 to 20");
    if (i == 0) continue;
    const float forward = corner.x_m - ground[i - 1].x_m, up = corner.y_m - ground[i - 1].y_m;
    if (forward < 0.0f) return Fail(ErrorCode::kStructure, NameOf(i, "x_m"), "corners go from left to right");
    if (forward == 0.0f) {
      if (std::abs(up) < kLeastCornerStep)
        return Fail(ErrorCode::kStructure, NameOf(i, "y_m"), "a vertical face is at least 0.01 m high");
      if (i >= 2 && ground[i - 2].x_m == corner.x_m)
        return Fail(ErrorCode::kStructure, NameOf(i, "x_m"), "at most two corners may be above each other");
    } else if (forward < kLeastCornerStep) {
      return Fail(ErrorCode::kStructure, NameOf(i, "x_m"),
                  "must be at least 0.01 m from the corner before, or the same");
    }
  }
  return {};
}

Terrain::Terrain(std::span<const Corner> ground) {
  if (ground.empty()) {
    faces_.push_back({-kFarAway, 0.0, 2.0 * kFarAway, 1.0, 0.0});
    return;
  }
  faces_.reserve(ground.size() + 1);
  const auto first_x = static_cast<double>(ground.front().x_m);
  faces_.push_back({-kFarAway, static_cast<double>(ground.front().y_m), kFarAway + first_x, 1.0, 0.0});
  for (std::size_t i = 0; i + 1 < ground.size(); ++i) {
    const auto x = static_cast<double>(ground[i].x_m), y = static_cast<double>(ground[i].y_m);
    const double dx = static_cast<double>(ground[i + 1].x_m) - x;
    const double dy = static_cast<double>(ground[i + 1].y_m) - y;
    const double length = std::sqrt(dx * dx + dy * dy);
    faces_.push_back({x, y, length, dx / length, dy / length});
  }
  faces_.push_back(
      {static_cast<double>(ground.back().x_m), static_cast<double>(ground.back().y_m), kFarAway, 1.0, 0.0});
  for (std::size_t i = 1; i < faces_.size(); ++i) {
    const Face& before = faces_[i - 1];
    const Face& after = faces_[i];
    if (before.ux * after.uy - before.uy * after.ux >= -1e-6) continue;  // it goes straight on, or up
    edges_.push_back({after.x, after.y, -before.ux, -before.uy, after.ux, after.uy});
  }
}

int Terrain::Edge::SideOfGround(double ux, double uy) const {
  // A face that lies along the line is on neither side.
  constexpr double kAlong = 0.02;
  const double back = ux * back_y - uy * back_x, on = ux * on_y - uy * on_x;
  if (back * on < 0.0 && std::min(std::abs(back), std::abs(on)) > kAlong) return 0;
  const double side = std::abs(back) > std::abs(on) ? back : on;
  return side > 0.0 ? 1 : (side < 0.0 ? -1 : 0);
}

double Terrain::HeightAt(double x) const {
  double height = -kFarAway;
  for (const Face& face : FacesBetween(x, x)) {
    if (face.ux > 0.0) height = std::max(height, face.y + (x - face.x) * (face.uy / face.ux));
  }
  return height;
}

double Terrain::NextCorner(double x, int side) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < faces_.size(); ++i) {
    const double ahead = (faces_[i].x - x) * side;
    if (ahead > 0.0) least = std::min(least, ahead);
  }
  return least;
}

std::span<const Terrain::Face> Terrain::FacesBetween(double left, double right) const {
  const auto begin =
      std::ranges::find_if(faces_, [&](const Face& f) { return f.x + f.length * f.ux >= left; });
  const auto end = std::find_if(begin, faces_.end(), [&](const Face& f) { return f.x > right; });
  return {begin, end};
}

std::span<const Terrain::Edge> Terrain::EdgesBetween(double left, double right) const {
  const auto begin = std::ranges::find_if(edges_, [&](const Edge& e) { return e.x >= left; });
  const auto end = std::find_if(begin, edges_.end(), [&](const Edge& e) { return e.x > right; });
  return {begin, end};
}

}  // namespace gaitsmith
