// SPDX-License-Identifier: MIT
#include "core/physics/figure.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

std::string Words(float number) {
  std::string text = std::to_string(number);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

Result<void> CheckNumber(float value, float low, float high, const std::string& where) {
  if (!std::isfinite(value)) return Fail(ErrorCode::kNotFinite, where, "must be a finite number");
  if (value < low || value > high) {
    return Fail(ErrorCode::kOutOfRange, where,
                "must be from " + Words(low) + " to " + Words(high) + ", is " + Words(value));
  }
  return {};
}
Result<void> CheckNumber(float value, float low, float high, int rod, const char* field) {
  return CheckNumber(value, low, high, RodPath(rod, field));
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

std::string SpringPath(std::size_t spring, const char* field) {
  return "springs[" + std::to_string(spring) + "]." + field;
}

Result<void> CheckNodes(const Figure& figure) {
  if (figure.nodes.size() > kMaxPoints) {
    return Fail(
        ErrorCode::kTooMany, "nodes",
        "at most " + std::to_string(kMaxPoints) + " nodes, there are " + std::to_string(figure.nodes.size()));
  }
  for (std::size_t i = 0; i < figure.nodes.size(); ++i) {
    const Node& node = figure.nodes[i];
    const auto path = [&](const char* field) { return "nodes[" + std::to_string(i) + "]." + field; };
    if (auto ok = CheckNumber(node.x_m, -1000.0f, 1000.0f, path("x_m")); !ok) return ok;
    if (auto ok = CheckNumber(node.y_m, -1000.0f, 1000.0f, path("y_m")); !ok) return ok;
    if (auto ok = CheckNumber(node.mass_kg, 1e-6f, 1e6f, path("mass_kg")); !ok) return ok;
  }
  return {};
}

/// The ends of a spring, and that no other one has both.
Result<void> CheckEnds(const Figure& figure, std::size_t i) {
  const Spring& spring = figure.springs[i];
  const auto count = static_cast<int>(figure.nodes.size());
  for (const auto& [end, field] : {std::pair(spring.from, "from"), std::pair(spring.to, "to")}) {
    if (end < 0 || end >= count) {
      return Fail(ErrorCode::kStructure, SpringPath(i, field),
                  "there is no node " + std::to_string(end) + ", the figure has nodes 0 to " +
                      std::to_string(count - 1));
    }
  }
  if (spring.from == spring.to)
    return Fail(ErrorCode::kStructure, SpringPath(i, "to"), "a spring needs two different nodes");
  for (std::size_t other = 0; other < i; ++other) {
    const Spring& there = figure.springs[other];
    if (std::minmax(there.from, there.to) == std::minmax(spring.from, spring.to)) {
      return Fail(ErrorCode::kStructure, SpringPath(i, "to"),
                  "spring " + std::to_string(other) + " is between the same nodes");
    }
  }
  if (DrawnLength(figure, spring) < kShortestSpring) {
    return Fail(ErrorCode::kOutOfRange, SpringPath(i, "to"),
                "its nodes must be drawn at least " + Words(kShortestSpring) + " m apart");
  }
  return {};
}

Result<void> CheckSprings(const Figure& figure) {
  if (figure.springs.size() > kMaxSprings) {
    return Fail(ErrorCode::kTooMany, "springs",
                "at most " + std::to_string(kMaxSprings) + " springs, there are " +
                    std::to_string(figure.springs.size()));
  }
  for (std::size_t i = 0; i < figure.springs.size(); ++i) {
    if (auto ok = CheckEnds(figure, i); !ok) return ok;
    const Spring& spring = figure.springs[i];
    const auto path = [&](const char* field) { return SpringPath(i, field); };
    if (auto ok = CheckNumber(spring.stiffness_npm, 0.0f, 1e6f, path("stiffness_npm")); !ok) return ok;
    if (auto ok = CheckNumber(spring.damping_nspm, 0.0f, 1e6f, path("damping_nspm")); !ok) return ok;
    if (auto ok = CheckNumber(spring.rest, kLeastRest, kMostRest, path("rest")); !ok) return ok;
    if (auto ok = CheckNumber(spring.min_rest, kLeastRest, spring.rest, path("min_rest")); !ok) return ok;
    if (auto ok = CheckNumber(spring.max_rest, spring.rest, kMostRest, path("max_rest")); !ok) return ok;
  }
  if (figure.Muscles() > kMaxMuscles) {
    return Fail(
        ErrorCode::kTooMany, "springs",
        "at most " + std::to_string(kMaxMuscles) + " muscles, there are " + std::to_string(figure.Muscles()));
  }
  return {};
}

/// Springs lead from each node to every other one.
Result<void> CheckHolds(const Figure& figure) {
  std::vector<char> reached(figure.nodes.size(), 0);
  reached.front() = 1;
  for (std::size_t round = 0; round < figure.nodes.size(); ++round) {
    for (const Spring& spring : figure.springs) {
      char &from = reached[static_cast<std::size_t>(spring.from)],
           &to = reached[static_cast<std::size_t>(spring.to)];
      from = to = from != 0 || to != 0 ? 1 : 0;
    }
  }
  for (std::size_t i = 0; i < reached.size(); ++i) {
    if (reached[i] == 0) {
      return Fail(ErrorCode::kStructure, "nodes[" + std::to_string(i) + "]",
                  "no springs lead from here to node 0");
    }
  }
  return {};
}

Result<void> CheckVibration(const Figure& figure) {
  int node = 0;
  const float fastest = FastestVibration(figure, &node);
  if (fastest <= kStiffest) return {};
  const float mass = figure.nodes[static_cast<std::size_t>(node)].mass_kg;
  return Fail(ErrorCode::kOutOfRange, "nodes[" + std::to_string(node) + "].mass_kg",
              "is too little for the springs there: their stiffness may add up to " +
                  Words(0.5f * kStiffest * mass) + " N/m, and adds up to " + Words(0.5f * fastest * mass));
}

}  // namespace

int Figure::Muscles() const {
  return static_cast<int>(std::ranges::count_if(springs, [](const Spring& each) { return each.IsMuscle(); }));
}

float DrawnLength(const Figure& figure, const Spring& spring) {
  const Node& from = figure.nodes[static_cast<std::size_t>(spring.from)];
  const Node& to = figure.nodes[static_cast<std::size_t>(spring.to)];
  const float x = to.x_m - from.x_m, y = to.y_m - from.y_m;
  return std::sqrt(x * x + y * y);
}

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

float FastestVibration(const Figure& figure, int* node) {
  std::vector<float> stiffness(figure.nodes.size(), 0.0f);
  for (const Spring& spring : figure.springs) {
    stiffness[static_cast<std::size_t>(spring.from)] += spring.stiffness_npm;
    stiffness[static_cast<std::size_t>(spring.to)] += spring.stiffness_npm;
  }
  float fastest = 0.0f;
  for (std::size_t i = 0; i < figure.nodes.size(); ++i) {
    const float here = 2.0f * stiffness[i] / figure.nodes[i].mass_kg;
    if (here <= fastest) continue;
    fastest = here;
    if (node != nullptr) *node = static_cast<int>(i);
  }
  return fastest;
}

Result<void> Validate(const Figure& figure) {
  if (!figure.HasSprings()) {
    if (!figure.springs.empty()) return Fail(ErrorCode::kMissing, "nodes", "a figure of springs needs nodes");
    if (figure.rods.empty()) return Fail(ErrorCode::kMissing, "rods", "a figure needs at least one rod");
    return CheckRods(figure);
  }
  if (!figure.rods.empty())
    return Fail(ErrorCode::kStructure, "nodes", "a figure has either rods, or nodes and springs");
  for (const auto check : {CheckNodes, CheckSprings, CheckHolds, CheckVibration}) {
    if (auto ok = check(figure); !ok) return ok;
  }
  return {};
}

}  // namespace gaitsmith
