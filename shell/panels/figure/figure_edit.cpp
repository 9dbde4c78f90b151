// SPDX-License-Identifier: MIT
// Geometry of the figure's drawing board.
#include "shell/panels/figure/figure_edit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/numeric/scalar_math.h"
#include "shell/stage/figure_drawing.h"

namespace gaitsmith::shell {
namespace {

constexpr float kPiF = static_cast<float>(kPi);

float Wrapped(float angle) {
  while (angle > kPiF) angle -= 2.0f * kPiF;
  while (angle < -kPiF) angle += 2.0f * kPiF;
  return angle;
}

// Dragged values are rounded to whole centimetres and half degrees, to keep files readable.
float RoundLength(float metres) { return std::max(0.01f, std::round(metres * 100.0f) / 100.0f); }
float RoundAngle(float radians) {
  constexpr float kHalfDegree = kPiF / 360.0f;
  return std::round(radians / kHalfDegree) * kHalfDegree;
}

float Distance(ImVec2 from, ImVec2 to) { return std::hypot(to.x - from.x, to.y - from.y); }

/// Mirrors a joint. A root has no joint, and its angle is measured from the ground.
void MirrorJoint(Rod& rod) {
  rod.rest_rad = rod.parent == kNoParent ? Wrapped(kPiF - rod.rest_rad) : Wrapped(-rod.rest_rad);
  const float least = rod.min_rad;
  rod.min_rad = -rod.max_rad;
  rod.max_rad = -least;
}

/// Marks a rod and all its descendants. Rods may be listed in any order.
std::vector<bool> LimbOf(const Figure& figure, int rod) {
  std::vector<bool> limb(figure.rods.size(), false);
  limb[static_cast<std::size_t>(rod)] = true;
  for (std::size_t pass = 0; pass < limb.size(); ++pass) {
    for (std::size_t i = 0; i < limb.size(); ++i) {
      const int parent = figure.rods[i].parent;
      if (parent != kNoParent && limb[static_cast<std::size_t>(parent)]) limb[i] = true;
    }
  }
  return limb;
}

float DirectionOf(const DrawnFigure& drawn, int limb) {
  const auto i = static_cast<std::size_t>(limb);
  return Direction(drawn.points[static_cast<std::size_t>(drawn.skeleton.limbs[i].start)],
                   drawn.points[i + 1]);
}

}  // namespace

Figure WithEndpointAt(const DrawnFigure& drawn, int endpoint, ImVec2 target) {
  const int limb = std::max(0, endpoint - 1);
  const Skeleton::Limb& moved = drawn.skeleton.limbs[static_cast<std::size_t>(limb)];
  const ImVec2 from = endpoint == 0 ? target : drawn.points[static_cast<std::size_t>(moved.start)];
  const ImVec2 to = endpoint == 0 ? drawn.points[1] : target;
  Figure figure = drawn.figure;
  Rod& rod = figure.rods[static_cast<std::size_t>(moved.drawn)];
  const float before = DirectionOf(drawn, limb);
  const float parent = moved.parent < 0 ? 0.0f : DirectionOf(drawn, moved.parent);
  const float after = RoundAngle(Direction(from, to));
  rod.length_m = RoundLength(Distance(from, to));
  rod.rest_rad = Wrapped(after - parent);
  for (Rod& child : figure.rods) {
    if (child.parent == moved.drawn) child.rest_rad = Wrapped(child.rest_rad + before - after);
  }
  return figure;
}

Figure WithLimbTurned(const DrawnFigure& drawn, int limb, float direction_rad) {
  const Skeleton::Limb& turned = drawn.skeleton.limbs[static_cast<std::size_t>(limb)];
  const float parent = turned.parent < 0 ? 0.0f : DirectionOf(drawn, turned.parent);
  Figure figure = drawn.figure;
  figure.rods[static_cast<std::size_t>(turned.drawn)].rest_rad =
      Wrapped(RoundAngle(Wrapped(direction_rad)) - parent);
  return figure;
}

float SnappedAngle(float radians) {
  constexpr float kStep = kPiF / 12.0f;
  return std::round(radians / kStep) * kStep;
}

ImVec2 Snapped(ImVec2 from, ImVec2 to) {
  constexpr float kStep = 0.05f;
  const float length = std::max(kStep, std::round(Distance(from, to) / kStep) * kStep);
  const float angle = SnappedAngle(Direction(from, to));
  return {from.x + length * std::cos(angle), from.y + length * std::sin(angle)};
}

Figure SingleRod() {
  return {.name = "", .rods = {{.length_m = 1.0f, .mass_kg = 1.0f, .rest_rad = 0.5f * kPiF}}};
}

Figure RodBetween(ImVec2 from, ImVec2 to) {
  const float length_m = RoundLength(Distance(from, to));
  return {.name = "",
          .rods = {{.length_m = length_m, .mass_kg = length_m, .rest_rad = RoundAngle(Direction(from, to))}}};
}

Figure WithRodFrom(const DrawnFigure& drawn, int endpoint, ImVec2 target) {
  const int limb = std::max(0, endpoint - 1);
  Figure figure = drawn.figure;
  float mass = 0.0f;
  float length = 0.0f;
  for (const Rod& rod : figure.rods) {
    mass += rod.mass_kg;
    length += rod.length_m;
  }
  const ImVec2 from = drawn.points[static_cast<std::size_t>(endpoint)];
  Rod rod;
  rod.length_m = RoundLength(Distance(from, target));
  rod.mass_kg = std::max(0.01f, std::round(rod.length_m * mass / length * 100.0f) / 100.0f);
  rod.parent = drawn.skeleton.limbs[static_cast<std::size_t>(limb)].drawn;
  rod.parent_end = endpoint == 0 ? RodEnd::kStart : RodEnd::kEnd;
  rod.rest_rad = Wrapped(RoundAngle(Direction(from, target)) - DirectionOf(drawn, limb));
  figure.rods.push_back(rod);
  return figure;
}

Figure WithRodGrown(const Figure& figure, int rod) {
  const Skeleton bones(figure);
  const std::vector<ImVec2> points = PoseOf(bones, {});
  const DrawnFigure drawn{.figure = figure, .skeleton = bones, .points = points};
  int limb = 0;
  while (bones.limbs[static_cast<std::size_t>(limb)].drawn != rod) ++limb;
  const ImVec2 tip = points[static_cast<std::size_t>(limb) + 1];
  const float length = bones.limbs[static_cast<std::size_t>(limb)].length_m;
  ImVec2 target;
  // Try directions +30°, −30°, +60°, … until one is free.
  for (int turn = 1; turn < 12; ++turn) {
    const int side = turn % 2 == 1 ? (turn + 1) / 2 : -turn / 2;
    const float angle = DirectionOf(drawn, limb) + static_cast<float>(side) * kPiF / 6.0f;
    target = {tip.x + length * std::cos(angle), tip.y + length * std::sin(angle)};
    const auto taken = [&](ImVec2 point) { return Distance(point, target) < 0.2f * length; };
    if (std::ranges::none_of(points, taken)) break;
  }
  return WithRodFrom(drawn, limb + 1, target);
}

Figure WithoutRod(const Figure& figure, int rod) {
  const std::vector<bool> gone = LimbOf(figure, rod);
  Figure rest = figure;
  rest.rods.clear();
  std::vector<int> index(gone.size(), kNoParent);
  for (std::size_t i = 0; i < gone.size(); ++i) {
    if (gone[i]) continue;
    index[i] = rest.Rods();
    rest.rods.push_back(figure.rods[i]);
  }
  for (Rod& kept : rest.rods) {
    if (kept.parent != kNoParent) kept.parent = index[static_cast<std::size_t>(kept.parent)];
  }
  return rest;
}

Figure WithLimbCopied(const Figure& figure, int rod) {
  const std::vector<bool> limb = LimbOf(figure, rod);
  Figure grown = figure;
  std::vector<int> index(limb.size(), kNoParent);
  for (std::size_t i = 0; i < limb.size(); ++i) {
    if (!limb[i]) continue;
    index[i] = grown.Rods();
    grown.rods.push_back(figure.rods[i]);
    MirrorJoint(grown.rods.back());
  }
  for (std::size_t i = 0; i < limb.size(); ++i) {
    if (!limb[i] || static_cast<int>(i) == rod) continue;
    grown.rods[static_cast<std::size_t>(index[i])].parent =
        index[static_cast<std::size_t>(figure.rods[i].parent)];
  }
  Rod& top = grown.rods[static_cast<std::size_t>(index[static_cast<std::size_t>(rod)])];
  constexpr float kClose = 0.1f;
  constexpr float kTurn = kPiF / 9.0f;  // 20°: 18 turns make a circle
  const auto taken = [&] {
    return std::ranges::any_of(figure.rods, [&](const Rod& other) {
      return other.parent == top.parent && other.parent_end == top.parent_end &&
             std::abs(Wrapped(other.rest_rad - top.rest_rad)) < kClose;
    });
  };
  for (int turn = 0; turn < 18 && taken(); ++turn) top.rest_rad = Wrapped(top.rest_rad + kTurn);
  return grown;
}

Figure Mirrored(const Figure& figure) {
  Figure mirrored = figure;
  for (Rod& rod : mirrored.rods) MirrorJoint(rod);
  return mirrored;
}

}  // namespace gaitsmith::shell
