// SPDX-License-Identifier: MIT
#include "shell/stage/limb_grip.h"

#include <algorithm>
#include <cmath>

#include "core/rollout/demonstration.h"

namespace gaitsmith::shell {
namespace {

// Counterclockwise from the right [rad]. Canvas y points down.
float CanvasDirection(ImVec2 from, ImVec2 to) { return std::atan2(from.y - to.y, to.x - from.x); }

}  // namespace

ImVec2 StartOf(const Skeleton& bones, const std::vector<ImVec2>& points, int limb) {
  return points[static_cast<std::size_t>(bones.limbs[static_cast<std::size_t>(limb)].start)];
}

float DirectionOf(const Skeleton& bones, const std::vector<ImVec2>& points, int limb) {
  return CanvasDirection(StartOf(bones, points, limb), points[static_cast<std::size_t>(limb) + 1]);
}

int LimbAt(const Skeleton& bones, const std::vector<ImVec2>& points, ImVec2 pointer, float within,
           int first) {
  int found = LimbGrip::kNone;
  for (int limb = first; limb < bones.rods; ++limb) {
    const ImVec2 a = StartOf(bones, points, limb);
    const ImVec2 b = points[static_cast<std::size_t>(limb) + 1];
    const ImVec2 along(b.x - a.x, b.y - a.y);
    const float square = std::max(1e-6f, along.x * along.x + along.y * along.y);
    const float share = ((pointer.x - a.x) * along.x + (pointer.y - a.y) * along.y) / square;
    const float inside = std::clamp(share, 0.2f, 1.0f);
    const float distance = std::hypot(pointer.x - a.x - inside * along.x, pointer.y - a.y - inside * along.y);
    if (distance >= within) continue;
    within = distance;
    found = limb;
  }
  return found;
}

void DrawReach(ImDrawList* list, const Skeleton& bones, const std::vector<ImVec2>& points, int limb,
               float angle_rad, ImU32 colour) {
  const Skeleton::Limb& bone = bones.limbs[static_cast<std::size_t>(limb)];
  const ImVec2 joint = StartOf(bones, points, limb);
  const ImVec2 tip = points[static_cast<std::size_t>(limb) + 1];
  const float radius = std::hypot(tip.x - joint.x, tip.y - joint.y);
  const float zero = DirectionOf(bones, points, limb) - angle_rad;
  const float first = -(zero + bone.max_rad), last = -(zero + bone.min_rad);
  for (const float end : {first, last}) {
    list->AddLine(joint, {joint.x + radius * std::cos(end), joint.y + radius * std::sin(end)}, colour, 1.5f);
  }
  list->PathArcTo(joint, radius, first, last, 48);
  list->PathStroke(colour, 0, 3.0f);
}

LimbGrip GripOf(const Skeleton& bones, const std::vector<ImVec2>& points, int limb, ImVec2 pivot,
                ImVec2 pointer) {
  return {limb, CanvasDirection(pivot, pointer) - DirectionOf(bones, points, limb)};
}

float TurnToward(const Skeleton& bones, const std::vector<ImVec2>& points, const LimbGrip& grip, ImVec2 pivot,
                 ImVec2 pointer) {
  const float wanted = CanvasDirection(pivot, pointer) - grip.grip_rad;
  const float turn = wanted - DirectionOf(bones, points, grip.limb);
  return static_cast<float>(WithoutWholeTurns(static_cast<double>(turn)));
}

}  // namespace gaitsmith::shell
