// SPDX-License-Identifier: MIT
#include "shell/session/ground_stroke.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/world/terrain.h"

namespace gaitsmith::shell {
namespace {

constexpr float kShortest = 0.05f;  // of a line, along the ground [m]
// Corners on the grid of centimetres that are nearer than this may be too near for a ground, once rounded.
constexpr float kApart = 0.015f;
constexpr float kSteep = 2.75f;  // rise over run, 70°

/// From left to right. What goes back becomes vertical.
std::vector<Corner> Rightward(std::span<const Corner> drawn) {
  std::vector<Corner> line(drawn.begin(), drawn.end());
  if (!line.empty() && line.back().x_m < line.front().x_m) std::ranges::reverse(line);
  for (std::size_t i = 1; i < line.size(); ++i) line[i].x_m = std::max(line[i].x_m, line[i - 1].x_m);
  return line;
}

float Distance(const Corner& p, const Corner& a, const Corner& b) {
  const float dx = b.x_m - a.x_m, dy = b.y_m - a.y_m;
  const float square = dx * dx + dy * dy;
  const float share =
      square > 0.0f ? std::clamp(((p.x_m - a.x_m) * dx + (p.y_m - a.y_m) * dy) / square, 0.0f, 1.0f) : 0.0f;
  return std::hypot(p.x_m - a.x_m - share * dx, p.y_m - a.y_m - share * dy);
}

/// The points that show the line's shape [Douglas Peucker 1973].
void Simplify(std::span<const Corner> line, float detail_m, std::vector<Corner>& kept) {
  if (line.size() < 3) return;
  std::size_t farthest = 0;
  float most = detail_m;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const float distance = Distance(line[i], line.front(), line.back());
    if (distance <= most) continue;
    most = distance;
    farthest = i;
  }
  if (farthest == 0) return;
  Simplify(line.first(farthest + 1), detail_m, kept);
  kept.push_back(line[farthest]);
  Simplify(line.subspan(farthest), detail_m, kept);
}

/// On the grid, with vertical faces where the line is steep, and without points that a ground cannot have.
std::vector<Corner> Squared(const std::vector<Corner>& line) {
  std::vector<Corner> out;
  for (const Corner& point : line) {
    Corner next = OnGrid(point);
    if (out.empty()) {
      out.push_back(next);
      continue;
    }
    const Corner last = out.back();
    next.x_m = std::max(next.x_m, last.x_m);
    const bool above = out.size() > 1 && out[out.size() - 2].x_m == last.x_m;  // a vertical face ends here
    const float along = next.x_m - last.x_m, rise = std::abs(next.y_m - last.y_m);
    const bool near = along < kApart;
    if (above && near) {
      next.x_m = OnGrid({last.x_m + 2.0f * kLeastCornerStep, 0.0f}).x_m;
    } else if (near || (!above && rise > kSteep * along)) {
      next.x_m = last.x_m;
      if (rise < kApart) continue;
    }
    out.push_back(next);
  }
  return out;
}

/// The ground's height where it meets a place from the left, or from the right.
float HeightBeside(std::span<const Corner> ground, float x_m, bool from_left) {
  if (ground.empty()) return 0.0f;
  const auto after =
      std::ranges::find_if(ground, [&](const Corner& c) { return from_left ? c.x_m >= x_m : c.x_m > x_m; });
  if (after == ground.end()) return ground.back().y_m;
  if (after == ground.begin()) return ground.front().y_m;
  const Corner &a = *std::prev(after), &b = *after;
  return a.y_m + (b.y_m - a.y_m) * (x_m - a.x_m) / (b.x_m - a.x_m);
}

/// The middle one of three corners above each other is none.
void DropBetween(std::vector<Corner>& ground) {
  for (std::size_t i = 2; i < ground.size();) {
    if (ground[i - 2].x_m == ground[i].x_m) {
      ground.erase(ground.begin() + static_cast<std::ptrdiff_t>(i) - 1);
    } else {
      ++i;
    }
  }
  for (std::size_t i = 1; i < ground.size();) {
    if (ground[i - 1].x_m == ground[i].x_m && std::abs(ground[i - 1].y_m - ground[i].y_m) < kApart) {
      ground.erase(ground.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
}

/// Puts a line between what is left and right of it.
std::vector<Corner> Joined(std::span<const Corner> ground, std::vector<Corner> line, float near_m) {
  const float left_m = line.front().x_m, right_m = line.back().x_m;
  std::vector<Corner> out;
  std::ranges::copy_if(ground, std::back_inserter(out),
                       [&](const Corner& c) { return c.x_m < left_m - kApart; });
  const float before = HeightBeside(ground, left_m, true), after = HeightBeside(ground, right_m, false);
  if (std::abs(line.front().y_m - before) < near_m) line.front().y_m = before;
  if (std::abs(line.back().y_m - after) < near_m) line.back().y_m = after;
  if (line.front().y_m != before) out.push_back({left_m, before});
  out.insert(out.end(), line.begin(), line.end());
  const auto rest = std::ranges::find_if(ground, [&](const Corner& c) { return c.x_m > right_m + kApart; });
  if (rest != ground.end() && line.back().y_m != after) out.push_back({right_m, after});
  out.insert(out.end(), rest, ground.end());
  DropBetween(out);
  return WithoutNeedless(std::move(out));
}

}  // namespace

Corner OnGrid(Corner corner) {
  const auto rounded = [](float metres, float most) {
    return static_cast<float>(std::lround(std::clamp(metres, -most, most) * 100.0f)) / 100.0f;
  };
  return {rounded(corner.x_m, kMaxCornerX), rounded(corner.y_m, kMaxCornerY)};
}

std::vector<Corner> WithoutNeedless(std::vector<Corner> ground) {
  constexpr float kStraight = 0.002f;
  for (std::size_t i = 1; i + 1 < ground.size();) {
    const bool vertical = ground[i - 1].x_m == ground[i].x_m || ground[i].x_m == ground[i + 1].x_m;
    if (!vertical && Distance(ground[i], ground[i - 1], ground[i + 1]) < kStraight) {
      ground.erase(ground.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
  // Before the first corner and behind the last one the ground is level anyway.
  while (ground.size() > 1 && ground[0].y_m == ground[1].y_m) ground.erase(ground.begin());
  while (ground.size() > 1 && ground[ground.size() - 2].y_m == ground.back().y_m) ground.pop_back();
  if (ground.size() == 1 && ground[0].y_m == 0.0f) ground.clear();
  return ground;
}

std::optional<std::vector<Corner>> WithStroke(std::span<const Corner> ground, std::span<const Corner> drawn,
                                              float detail_m) {
  const std::vector<Corner> line = Rightward(drawn);
  if (line.size() < 2 || line.back().x_m - line.front().x_m < kShortest) return std::nullopt;
  constexpr int kTries = 20;
  constexpr float kCoarser = 1.4f;
  float detail = detail_m;
  for (int attempt = 0; attempt < kTries; ++attempt, detail *= kCoarser) {
    std::vector<Corner> kept = {line.front()};
    Simplify(line, detail, kept);
    kept.push_back(line.back());
    const std::vector<Corner> squared = Squared(kept);
    if (squared.back().x_m - squared.front().x_m < kApart) return std::nullopt;
    std::vector<Corner> joined = Joined(ground, squared, 4.0f * detail_m);
    if (Validate(joined)) return joined;
  }
  return std::nullopt;
}

}  // namespace gaitsmith::shell
