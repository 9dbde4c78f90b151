// SPDX-License-Identifier: MIT
// A validated figure, laid out for the simulation: rods sorted parents first, and every constant precomputed.
#pragma once

#include <array>

#include "core/physics/figure.h"

namespace gaitsmith {

/// Rods are renumbered in walking order (root first). Joint j turns walked rod j + 1. Endpoint 0 is the
/// root's start, endpoint i + 1 the end of walked rod i.
struct Skeleton {
  struct Limb {
    float length_m;
    float mass_kg;
    float inertia_kgm2;  // about its own midpoint, m l^2 / 12
    int parent;          // walked index; -1 for the root
    int start;           // endpoint where it starts
    float rest_rad;      // drawn angle relative to the parent
    float min_rad, max_rad;
    float inverse_range;  // 1 / (max - min); 0 for a locked joint, whose sense is always 0
    int drawn;            // index in Figure::rods
  };

  /// @param figure must be valid (see Validate). One of springs has no rods: only its mass and its longest
  /// spring are here
  explicit Skeleton(const Figure& figure);

  int rods = 0;
  int joints = 0;
  int endpoints = 0;
  std::array<Limb, kMaxRods> limbs{};
  float mass_kg = 0.0f;          // of the whole figure
  float longest_rod_m = 0.0f;    // or spring, as drawn; scales the height sense and the ground-work guard
  float start_angle_rad = 0.0f;  // of the root against the horizontal, in the drawn pose
  int head = 0;  // highest endpoint of the drawn pose, the first one if several are equally high
};

/// The figure's ports: joints are the actuators, endpoints the contacts, both in the skeleton's order.
[[nodiscard]] Ports PortsOf(const Skeleton&);

}  // namespace gaitsmith
