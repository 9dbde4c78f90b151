// SPDX-License-Identifier: MIT
// What a figure of springs is, and whether it is valid.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/numeric/range.h"
#include "core/physics/figure.h"

namespace gaitsmith {

namespace {

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
    if (auto ok = CheckRange(node.x_m, -1000.0f, 1000.0f, path("x_m")); !ok) return ok;
    if (auto ok = CheckRange(node.y_m, -1000.0f, 1000.0f, path("y_m")); !ok) return ok;
    if (auto ok = CheckRange(node.mass_kg, 1e-6f, 1e6f, path("mass_kg")); !ok) return ok;
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
                "its nodes must be drawn at least " + NumberText(kShortestSpring) + " m apart");
  }
  return {};
}

Result<void> CheckSprings(const Figure& figure) {
  if (figure.springs.empty())
    return Fail(ErrorCode::kMissing, "springs", "a figure of springs needs at least one spring");
  if (figure.springs.size() > kMaxSprings) {
    return Fail(ErrorCode::kTooMany, "springs",
                "at most " + std::to_string(kMaxSprings) + " springs, there are " +
                    std::to_string(figure.springs.size()));
  }
  for (std::size_t i = 0; i < figure.springs.size(); ++i) {
    if (auto ok = CheckEnds(figure, i); !ok) return ok;
    const Spring& spring = figure.springs[i];
    const auto path = [&](const char* field) { return SpringPath(i, field); };
    if (auto ok = CheckRange(spring.stiffness_npm, 0.0f, 1e6f, path("stiffness_npm")); !ok) return ok;
    if (auto ok = CheckRange(spring.damping_nspm, 0.0f, 1e6f, path("damping_nspm")); !ok) return ok;
    if (auto ok = CheckRange(spring.rest, kLeastRest, kMostRest, path("rest")); !ok) return ok;
    if (auto ok = CheckRange(spring.min_rest, kLeastRest, spring.rest, path("min_rest")); !ok) return ok;
    if (auto ok = CheckRange(spring.max_rest, spring.rest, kMostRest, path("max_rest")); !ok) return ok;
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
                  NumberText(0.5f * kStiffest * mass) + " N/m, and adds up to " +
                  NumberText(0.5f * fastest * mass));
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

Result<void> ValidateSprings(const Figure& figure) {
  for (const auto check : {CheckNodes, CheckSprings, CheckHolds, CheckVibration}) {
    if (auto ok = check(figure); !ok) return ok;
  }
  return {};
}

}  // namespace gaitsmith
