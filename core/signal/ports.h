// SPDX-License-Identifier: MIT
// Where a controller is connected to a plant: actuators, each driven to a target, and contacts, each of which
// can feel the ground.
#pragma once

#include <array>
#include <vector>

namespace gaitsmith {

/// Most actuators and contacts of a plant. The lanes' state grows with them.
inline constexpr int kMaxActuators = 15;
inline constexpr int kMaxContacts = 17;

/// Standard gravity [m/s^2]. Scales the force senses, so that a change of gravity in a document is felt as
/// such.
inline constexpr float kStandardGravity = 9.8f;

/// The number of connections: all that the layout of a genome depends on.
struct PortCount {
  int actuators = 0;  // [0, kMaxActuators]
  int contacts = 0;   // [0, kMaxContacts]

  constexpr PortCount(int actuator_count, int contact_count)
      : actuators(actuator_count), contacts(contact_count) {}
  /// Those of an articulated figure: a tree of n rods has n - 1 joints and n + 1 endpoints.
  // NOLINTNEXTLINE(google-explicit-constructor): the number of rods of a figure says all of it
  constexpr PortCount(int rods) : actuators(rods - 1), contacts(rods + 1) {}

  bool operator==(const PortCount&) const = default;
};

/// The connections, and the scales that make readings comparable between plants.
struct Ports {
  std::vector<std::array<float, 2>> actuator_range;  // least and greatest position: [rad] of joints
  int contacts = 0;
  float mass_kg = 1.0f;   // of the whole plant: its weight is the unit of force
  float length_m = 1.0f;  // of its longest part: the unit of height

  [[nodiscard]] PortCount Count() const { return {static_cast<int>(actuator_range.size()), contacts}; }
};

}  // namespace gaitsmith
