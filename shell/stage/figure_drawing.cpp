// SPDX-License-Identifier: MIT
// Bodies, rods, joints and arrows.
#include "shell/stage/figure_drawing.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/scalar_math.h"
#include "shell/body/body_parts.h"
#include "shell/widgets/theme.h"

namespace gaitsmith::shell {

namespace {

constexpr float kQuarter = 0.5f * static_cast<float>(kPi);

/// Bodies smaller than this show no rods or joints [points].
constexpr float kLeastWithRods = 120.0f, kLeastWithJoints = 80.0f;
/// The least radius of an eye [points].
constexpr float kLeastEye = 1.1f;
/// A ring around a limb whose joint is at its limit, and the gap inside it [points].
constexpr float kRing = 4.5f, kRingGap = 2.0f;

/// A limb whose radius swells between its ends, by `belly` halfway, as one shape.
void DrawSwollenLimb(ImDrawList* list, ImVec2 from, float from_radius, ImVec2 to, float to_radius,
                     float belly, ImU32 colour) {
  constexpr int kSteps = 8;
  const float angle = std::atan2(to.y - from.y, to.x - from.x);
  const ImVec2 across(-std::sin(angle), std::cos(angle));
  const auto side = [&](int step, float sign) {
    const float share = static_cast<float>(step) / kSteps;
    const float radius =
        from_radius + (to_radius - from_radius) * share + belly * std::sin(share * static_cast<float>(kPi));
    list->PathLineTo({from.x + (to.x - from.x) * share + sign * radius * across.x,
                      from.y + (to.y - from.y) * share + sign * radius * across.y});
  };
  list->PathArcTo(to, to_radius, angle - kQuarter, angle + kQuarter);
  for (int step = kSteps - 1; step > 0; --step) side(step, 1.0f);
  list->PathArcTo(from, from_radius, angle + kQuarter, angle + 3.0f * kQuarter);
  for (int step = 1; step < kSteps; ++step) side(step, -1.0f);
  list->PathFillConvex(colour);
}

}  // namespace

void DrawLimb(ImDrawList* list, ImVec2 from, float from_radius, ImVec2 to, float to_radius, ImU32 colour) {
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  if (length <= std::abs(from_radius - to_radius) + 0.01f) {
    list->AddCircleFilled(from_radius > to_radius ? from : to, std::max(from_radius, to_radius), colour);
    return;
  }
  const float angle = std::atan2(to.y - from.y, to.x - from.x);
  // Where the common tangents touch the discs.
  const float touch = std::acos((from_radius - to_radius) / length);
  list->PathArcTo(to, to_radius, angle - touch, angle + touch);
  list->PathArcTo(from, from_radius, angle + touch, angle + 4.0f * kQuarter - touch);
  list->PathFillConvex(colour);
}

void DrawCapsule(ImDrawList* list, ImVec2 from, ImVec2 to, float width, ImU32 colour) {
  DrawLimb(list, from, 0.5f * width, to, 0.5f * width, colour);
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

void DrawBody(ImDrawList* list, const FigureLook& look, std::span<const ImVec2> endpoints, float scale,
              const BodyInk& ink) {
  using Side = FigureLook::Side;
  const auto at = [&](int endpoint) { return endpoints[static_cast<std::size_t>(endpoint)]; };
  const auto radius = [&](float metres) { return std::max(0.6f, metres * scale + ink.grow); };
  std::vector<BodyPoint> points;
  for (const ImVec2& point : endpoints) points.push_back({point.x / scale, -point.y / scale});
  const auto on_canvas = [&](BodyPoint point) { return ImVec2(point.x * scale, -point.y * scale); };
  const std::vector<BodyPart> parts = BodyPartsOf(look, points);
  for (const auto& [wider, colour] : {std::pair{kRing, ink.strain.tint}, {kRingGap, ink.strain.gap}}) {
    for (const BodyPart& part : parts) {
      if (ink.strain.Of(part.rod) >= ink.strain.limit)
        DrawLimb(list, on_canvas(part.from), radius(part.from_m) + wider, on_canvas(part.to),
                 radius(part.to_m) + wider, colour);
    }
  }
  for (const BodyPart& part : parts) {
    const ImU32 plain = part.far && ink.far != 0 ? ink.far : ink.body;
    const float strain = ink.strain.Of(part.rod);
    const ImU32 colour = strain > 0.0f ? Mix(plain, ink.strain.tint, strain) : plain;
    const ImVec2 from = on_canvas(part.from), to = on_canvas(part.to);
    if (part.belly_m > 0.0f) {
      DrawSwollenLimb(list, from, radius(part.from_m), to, radius(part.to_m), part.belly_m * scale, colour);
    } else {
      DrawLimb(list, from, radius(part.from_m), to, radius(part.to_m), colour);
    }
  }

  ImVec2 least = endpoints[0], most = endpoints[0];
  for (const ImVec2& point : endpoints) {
    least = {std::min(least.x, point.x), std::min(least.y, point.y)};
    most = {std::max(most.x, point.x), std::max(most.y, point.y)};
  }
  const float size = std::hypot(most.x - least.x, most.y - least.y);
  const bool springs = !look.knobs.empty();
  if (ink.rods != 0 && size > kLeastWithRods && !springs) {
    for (const FigureLook::Limb& limb : look.limbs) {
      if (limb.side != Side::kFar)
        list->AddLine(at(limb.from), at(limb.to), ink.rods, size > 2.0f * kLeastWithRods ? 1.5f : 1.0f);
    }
  }
  if (const auto eye = EyeOf(look, points); eye && ink.eye != 0)
    list->AddCircleFilled(on_canvas(eye->at), std::max(kLeastEye, eye->radius_m * scale), ink.eye);
  if (ink.joints == 0 || size < kLeastWithJoints) return;
  if (springs) {
    for (std::size_t node = 0; node < look.knobs.size(); ++node)
      list->AddCircleFilled(endpoints[node], 0.38f * radius(look.knobs[node]), ink.joints);
    return;
  }
  list->AddCircleFilled(endpoints[0], 0.55f * radius(look.middle_m), ink.joints);
  for (std::size_t rod = 0; rod < look.limbs.size(); ++rod) {
    const FigureLook::Limb& limb = look.limbs[rod];
    if (limb.side == Side::kFar || static_cast<int>(rod) == look.head_rod) continue;
    const float share = limb.end_m < 0.8f * limb.start_m ? 0.38f : 0.55f;
    list->AddCircleFilled(at(limb.to), share * radius(look.middle_m), ink.joints);
  }
}

void DrawRods(ImDrawList* list, std::span<const Bar> bars, std::span<const ImVec2> endpoints,
              const RodInk& ink) {
  const auto capsule = [&](const Bar& bar, float width, ImU32 colour) {
    DrawCapsule(list, endpoints[static_cast<std::size_t>(bar.from)],
                endpoints[static_cast<std::size_t>(bar.to)], width, colour);
  };
  for (const auto& [wider, colour] : {std::pair{kRing, ink.strain.tint}, {kRingGap, ink.strain.gap}}) {
    for (std::size_t rod = 1; rod < bars.size(); ++rod) {
      if (ink.strain.Of(static_cast<int>(rod)) >= ink.strain.limit)
        capsule(bars[rod], ink.width + 2.0f * wider, colour);
    }
  }
  std::vector<int> rods_at(endpoints.size(), 0);
  for (std::size_t rod = 0; rod < bars.size(); ++rod) {
    const float strain = ink.strain.Of(static_cast<int>(rod));
    capsule(bars[rod], ink.width, strain > 0.0f ? Mix(ink.rods, ink.strain.tint, strain) : ink.rods);
    ++rods_at[static_cast<std::size_t>(bars[rod].from)];
    ++rods_at[static_cast<std::size_t>(bars[rod].to)];
  }
  if (ink.joints == 0) return;
  for (std::size_t k = 0; k < endpoints.size(); ++k) {
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
  std::vector<ImVec2> points;
  for (const BodyPoint& point : DrawnEndpoints(skeleton, angle_rad)) points.emplace_back(point.x, point.y);
  return points;
}

std::vector<ImVec2> PoseOf(const Figure& figure) {
  std::vector<ImVec2> points;
  for (const BodyPoint& point : DrawnEndpoints(figure)) points.emplace_back(point.x, point.y);
  return points;
}

float DistanceToLine(ImVec2 point, ImVec2 from, ImVec2 to) {
  const ImVec2 along(to.x - from.x, to.y - from.y);
  const float square = std::max(1e-6f, along.x * along.x + along.y * along.y);
  const float share =
      std::clamp(((point.x - from.x) * along.x + (point.y - from.y) * along.y) / square, 0.0f, 1.0f);
  return std::hypot(point.x - from.x - share * along.x, point.y - from.y - share * along.y);
}

float Direction(ImVec2 from, ImVec2 to) { return std::atan2(to.y - from.y, to.x - from.x); }

float RodWidth(const Skeleton& skeleton, float points_per_metre) {
  float length = 0.0f;
  for (int rod = 0; rod < skeleton.rods; ++rod)
    length += skeleton.limbs[static_cast<std::size_t>(rod)].length_m;
  const float mean = length / static_cast<float>(skeleton.rods) * points_per_metre;
  return std::clamp(0.18f * mean, 3.0f, 26.0f);
}

float RodWidth(const Figure& figure, float points_per_metre) {
  if (!figure.HasSprings()) return RodWidth(Skeleton(figure), points_per_metre);
  return std::clamp(
      0.1f * SizeOf(figure) / std::sqrt(static_cast<float>(figure.nodes.size())) * points_per_metre, 2.0f,
      14.0f);
}

}  // namespace gaitsmith::shell
