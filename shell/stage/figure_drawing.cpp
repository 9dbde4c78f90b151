// SPDX-License-Identifier: MIT
// Rods, joints and arrows.
#include "shell/stage/figure_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/physics/pose.h"

namespace gaitsmith::shell {

void DrawCapsule(ImDrawList* list, ImVec2 from, ImVec2 to, float width, ImU32 colour) {
  const float half = 0.5f * width;
  const float angle = std::atan2(to.y - from.y, to.x - from.x);
  constexpr float kQuarter = 0.5f * static_cast<float>(kPi);
  list->PathArcTo(to, half, angle - kQuarter, angle + kQuarter);
  list->PathArcTo(from, half, angle + kQuarter, angle + 3.0f * kQuarter);
  list->PathFillConvex(colour);
}

void DrawArrow(ImDrawList* list, ImVec2 from, ImVec2 to, ImU32 colour, ImU32 edge) {
  const float dx = to.x - from.x;
  const float dy = to.y - from.y;
  const float length = std::sqrt(dx * dx + dy * dy);
  if (length < 4.0f) return;
  const ImVec2 along(dx / length, dy / length);
  const float head = std::min(8.0f, 0.6f * length);
  const auto barb = [&](float side) {
    return ImVec2(to.x - head * along.x - side * 0.62f * head * along.y,
                  to.y - head * along.y + side * 0.62f * head * along.x);
  };
  for (const auto& [ink, width] : {std::pair{edge, 5.5f}, std::pair{colour, 2.5f}}) {
    DrawCapsule(list, from, to, width, ink);
    DrawCapsule(list, barb(1.0f), to, width, ink);
    DrawCapsule(list, barb(-1.0f), to, width, ink);
  }
}

void DrawFigure(ImDrawList* list, const Skeleton& skeleton, std::span<const ImVec2> endpoints,
                const FigureInk& ink) {
  std::array<int, kMaxEndpoints> rods_at{};
  for (int rod = 0; rod < skeleton.rods; ++rod) {
    const auto i = static_cast<std::size_t>(rod);
    const auto start = static_cast<std::size_t>(skeleton.limbs[i].start);
    DrawCapsule(list, endpoints[start], endpoints[i + 1], ink.width, ink.rods);
    ++rods_at[start];
    ++rods_at[i + 1];
  }
  if (ink.joints == 0) return;
  for (std::size_t k = 0; k < static_cast<std::size_t>(skeleton.endpoints); ++k) {
    if (rods_at[k] >= 3) {
      // A hub, where three or more rods meet.
      list->AddCircleFilled(endpoints[k], 0.76f * ink.width, ink.rods);
      list->AddCircleFilled(endpoints[k], 0.48f * ink.width, ink.joints);
    } else {
      list->AddCircleFilled(endpoints[k], (rods_at[k] == 2 ? 0.34f : 0.28f) * ink.width, ink.joints);
    }
  }
}

std::vector<ImVec2> PoseOf(const Skeleton& skeleton, std::span<const float> angle_rad) {
  std::array<Lane<1>::F, kMaxJoints> angles{};
  for (std::size_t joint = 0; joint < angle_rad.size(); ++joint)
    angles[joint] = Lane<1>::Splat(angle_rad[joint]);
  Pose<1> pose;
  PoseFigure<1>(skeleton, angles, pose);
  // PoseFigure lays the root rod along x. Rotate the figure back to its drawn direction.
  const SineCosine turn = SinCos(skeleton.start_angle_rad);
  std::vector<ImVec2> points;
  for (std::size_t k = 0; k < static_cast<std::size_t>(skeleton.endpoints); ++k) {
    const float x = pose.endpoint_x[k][0];
    const float y = pose.endpoint_y[k][0];
    points.emplace_back(x * turn.cosine - y * turn.sine, x * turn.sine + y * turn.cosine);
  }
  return points;
}

float Direction(ImVec2 from, ImVec2 to) { return std::atan2(to.y - from.y, to.x - from.x); }

float RodWidth(const Skeleton& skeleton, float points_per_metre) {
  float length = 0.0f;
  for (int rod = 0; rod < skeleton.rods; ++rod)
    length += skeleton.limbs[static_cast<std::size_t>(rod)].length_m;
  const float mean = length / static_cast<float>(skeleton.rods) * points_per_metre;
  return std::clamp(0.18f * mean, 3.0f, 26.0f);
}

}  // namespace gaitsmith::shell
