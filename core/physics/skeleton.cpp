// SPDX-License-Identifier: MIT
#include "core/physics/skeleton.h"

#include <algorithm>

#include "core/physics/pose.h"

namespace gaitsmith {

namespace {

/// Endpoints within this share of the longest rod below the highest one count as equally high. Otherwise
/// rounding would decide between the ends of a symmetric figure.
constexpr float kSameHeight = 1e-4f;

int HighestEndpoint(const Skeleton& skeleton) {
  Pose<1> pose;
  PoseFigure<1>(skeleton, {}, pose);
  const SineCosine root = SinCos(skeleton.start_angle_rad);
  const auto endpoints = static_cast<std::size_t>(skeleton.endpoints);
  std::array<float, kMaxEndpoints> height_m{};
  for (std::size_t k = 0; k < endpoints; ++k) {
    height_m[k] = root.sine * pose.endpoint_x[k][0] + root.cosine * pose.endpoint_y[k][0];
  }
  const float highest = *std::max_element(height_m.begin(), height_m.begin() + skeleton.endpoints);
  int head = 0;
  while (height_m[static_cast<std::size_t>(head)] < highest - kSameHeight * skeleton.longest_rod_m) ++head;
  return head;
}

}  // namespace

Skeleton::Skeleton(const Figure& figure)
    : rods(figure.Rods()), joints(figure.Joints()), endpoints(rods > 0 ? figure.Endpoints() : 0) {
  for (const Node& node : figure.nodes) mass_kg += node.mass_kg;
  for (const Spring& spring : figure.springs)
    longest_rod_m = std::max(longest_rod_m, DrawnLength(figure, spring));
  if (rods == 0) return;
  // Number the rods in rounds: a rod gets its number once its parent has one. Ties go to the drawn order.
  std::array<int, kMaxRods> walked_index;
  walked_index.fill(-1);
  int walked = 0;
  while (walked < rods) {
    for (int drawn = 0; drawn < rods; ++drawn) {
      const Rod& rod = figure.rods[static_cast<std::size_t>(drawn)];
      const bool is_root = rod.parent == kNoParent;
      const int parent = is_root ? -1 : walked_index[static_cast<std::size_t>(rod.parent)];
      if (walked_index[static_cast<std::size_t>(drawn)] >= 0 || (!is_root && parent < 0)) continue;

      Limb& limb = limbs[static_cast<std::size_t>(walked)];
      limb.length_m = rod.length_m;
      limb.mass_kg = rod.mass_kg;
      limb.inertia_kgm2 = rod.mass_kg * rod.length_m * rod.length_m / 12.0f;
      limb.parent = parent;
      limb.start = is_root ? 0
                           : (rod.parent_end == RodEnd::kEnd ? parent + 1
                                                             : limbs[static_cast<std::size_t>(parent)].start);
      limb.rest_rad = is_root ? 0.0f : rod.rest_rad;
      limb.min_rad = is_root ? 0.0f : rod.min_rad;
      limb.max_rad = is_root ? 0.0f : rod.max_rad;
      const float range = limb.max_rad - limb.min_rad;
      limb.inverse_range = range > 0.0f ? 1.0f / range : 0.0f;
      limb.drawn = drawn;
      if (is_root) start_angle_rad = rod.rest_rad;

      mass_kg += rod.mass_kg;
      longest_rod_m = std::max(longest_rod_m, rod.length_m);
      walked_index[static_cast<std::size_t>(drawn)] = walked++;
    }
  }
  head = HighestEndpoint(*this);
}

Ports PortsOf(const Skeleton& skeleton) {
  Ports ports = {.actuator_range = {},
                 .contacts = skeleton.endpoints,
                 .mass_kg = skeleton.mass_kg,
                 .length_m = skeleton.longest_rod_m};
  for (int joint = 0; joint < skeleton.joints; ++joint) {
    const Skeleton::Limb& limb = skeleton.limbs[static_cast<std::size_t>(joint) + 1];
    ports.actuator_range.push_back({limb.min_rad, limb.max_rad});
  }
  return ports;
}

}  // namespace gaitsmith
