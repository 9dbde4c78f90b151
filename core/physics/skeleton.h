// SPDX-License-Identifier: MIT
// A validated figure, laid out for the simulation: rods sorted parents first, everything that never changes
// computed.
#pragma once

#include <array>

#include "core/physics/figure.h"

namespace gaitsmith {

/// Rods here are numbered in walking order (root first). Joint j turns walked rod j + 1; endpoint 0 is the
/// root's start, endpoint i + 1 the end of walked rod i.
struct Skeleton {
  struct Limb {
    float length_m;
    float mass_kg;
    float inertia_kgm2;  // about its own midpoint, m l^2 / 12
    int parent;          // walked index; -1 for the root
    int start;           // endpoint where it starts
    float rest_rad;      // drawn angle against the parent
    float min_rad, max_rad;
    float inverse_range;  // 1 / (max - min); 0 for a locked joint, which always feels its least angle
    int drawn;            // index in Figure::rods
  };

  /// @param figure must be valid (see Validate)
  explicit Skeleton(const Figure& figure);

  int rods = 0;
  int joints = 0;
  int endpoints = 0;
  std::array<Limb, kMaxRods> limbs{};
  float mass_kg = 0.0f;          // of the whole
  float longest_rod_m = 0.0f;    // scales the height sense and the ground-work guard
  float start_angle_rad = 0.0f;  // of the root against horizontal, in the drawn pose
  int head = 0;                  // highest endpoint of the drawn pose; of equals the first
};

/// Joints are the actuators, endpoints the contacts, both in the skeleton's order.
[[nodiscard]] Ports PortsOf(const Skeleton&);

}  // namespace gaitsmith
