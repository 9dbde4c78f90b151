// SPDX-License-Identifier: MIT
#include "core/physics/figure.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/range.h"

namespace gaitsmith {

namespace {

std::string RodPath(int rod, const char* field) { return "rods[" + std::to_string(rod) + "]." + field; }

Result<void> CheckTree(const Figure& figure) {
  int root = kNoParent;
  for (int rod = 0; rod < figure.Rods(); ++rod) {
    const int parent = figure.rods[static_cast<std::size_t>(rod)].parent;
    if (parent == kNoParent) {
      if (root != kNoParent) {
        return Fail(ErrorCode::kStructure, RodPath(rod, "parent"),
                    "a second root: rod " + std::to_string(root) + " has no parent either");
      }
      root = rod;
    } else if (parent < 0 || parent >= figure.Rods()) {
      return Fail(ErrorCode::kStructure, RodPath(rod, "parent"),
                  "there is no rod " + std::to_string(parent) + ", the figure has rods 0 to " +
                      std::to_string(figure.Rods() - 1));
    } else if (parent == rod) {
      return Fail(ErrorCode::kStructure, RodPath(rod, "parent"), "a rod cannot be its own parent");
    }
  }
  // Walking up from any rod must reach the root in at most as many steps as there are rods.
  for (int rod = 0; rod < figure.Rods(); ++rod) {
    int at = rod;
    for (int steps = 0; at != kNoParent; ++steps) {
      if (steps > figure.Rods()) {
        return Fail(ErrorCode::kStructure, RodPath(rod, "parent"), "its parents form a cycle");
      }
      at = figure.rods[static_cast<std::size_t>(at)].parent;
    }
  }
  return {};
}

Result<void> CheckNumber(float value, float low, float high, int rod, const char* field) {
  return CheckRange(value, low, high, RodPath(rod, field));
}

Result<void> CheckRods(const Figure& figure) {
  if (figure.Rods() > kMaxRods) {
    return Fail(ErrorCode::kTooMany, "rods",
                "at most " + std::to_string(kMaxRods) + " rods, there are " + std::to_string(figure.Rods()));
  }
  constexpr float kPiRad = 3.1415927f;
  for (int i = 0; i < figure.Rods(); ++i) {
    const Rod& rod = figure.rods[static_cast<std::size_t>(i)];
    if (auto ok = CheckNumber(rod.length_m, 0.001f, 1000.0f, i, "length_m"); !ok) return ok;
    if (auto ok = CheckNumber(rod.mass_kg, 1e-6f, 1e6f, i, "mass_kg"); !ok) return ok;
    if (auto ok = CheckNumber(rod.rest_rad, -2 * kPiRad, 2 * kPiRad, i, "rest_rad"); !ok) return ok;
    if (auto ok = CheckNumber(rod.min_rad, -kPiRad, 0.0f, i, "min_rad"); !ok) return ok;
    if (auto ok = CheckNumber(rod.max_rad, 0.0f, kPiRad, i, "max_rad"); !ok) return ok;
    if (auto ok = CheckNumber(rod.strength, 0.0f, 1000.0f, i, "strength"); !ok) return ok;
    if (auto ok = CheckNumber(rod.stiffness, 1.0f, 1e6f, i, "stiffness"); !ok) return ok;
  }
  return CheckTree(figure);
}

}  // namespace

float SizeOf(const Figure& figure) {
  if (figure.HasSprings()) {
    const auto [left, right] = std::ranges::minmax(figure.nodes, {}, &Node::x_m);
    const auto [low, high] = std::ranges::minmax(figure.nodes, {}, &Node::y_m);
    const float x = right.x_m - left.x_m, y = high.y_m - low.y_m;
    return std::max(std::sqrt(x * x + y * y), kShortestSpring);
  }
  float length = 0.0f;
  for (const Rod& rod : figure.rods) length += rod.length_m;
  return length / std::sqrt(static_cast<float>(figure.rods.size()));
}

bool SameTree(const Figure& one, const Figure& other) {
  const auto alike = [](const Spring& a, const Spring& b) {
    return a.from == b.from && a.to == b.to && a.IsMuscle() == b.IsMuscle();
  };
  return one.nodes.size() == other.nodes.size() && std::ranges::equal(one.springs, other.springs, alike) &&
         std::ranges::equal(one.rods, other.rods, [](const Rod& a, const Rod& b) {
           return a.parent == b.parent && a.parent_end == b.parent_end;
         });
}

Result<void> Validate(const Figure& figure) {
  if (!figure.HasSprings()) {
    if (!figure.springs.empty()) return Fail(ErrorCode::kMissing, "nodes", "a figure of springs needs nodes");
    if (figure.rods.empty()) return Fail(ErrorCode::kMissing, "rods", "a figure needs at least one rod");
    return CheckRods(figure);
  }
  if (!figure.rods.empty())
    return Fail(ErrorCode::kStructure, "nodes", "a figure has either rods, or nodes and springs");
  return ValidateSprings(figure);
}

}  // namespace gaitsmith
