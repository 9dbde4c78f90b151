// SPDX-License-Identifier: MIT
// The connections between a controller and a plant: actuators, each driven to a target, and contacts, each of
// which can sense the ground.
#pragma once

#include <array>
#include <vector>

namespace gaitsmith {

/// The most actuators and contacts that a plant may have. The size of the lanes' state grows with these
/// limits.
inline constexpr int kMaxActuators = 15;
inline constexpr int kMaxContacts = 24;

/// The numbers of connections, on which the layout of a genome depends, and what the actuators are.
struct PortCount {
  int actuators = 0;     // [0, kMaxActuators]
  int contacts = 0;      // [0, kMaxContacts]
  bool muscles = false;  // actuators change lengths instead of angles

  constexpr PortCount(int actuator_count, int contact_count, bool are_muscles = false)
      : actuators(actuator_count), contacts(contact_count), muscles(are_muscles) {}
  /// The connections of an articulated figure: a tree of n rods has n - 1 joints and n + 1 endpoints.
  // NOLINTNEXTLINE(google-explicit-constructor): the number of rods determines both counts
  constexpr PortCount(int rods) : actuators(rods - 1), contacts(rods + 1) {}

  bool operator==(const PortCount&) const = default;
};

/// The connections, and the scales that make readings comparable between plants.
struct Ports {
  std::vector<std::array<float, 2>> actuator_range;  // least and greatest position, [rad] for joints
  bool muscles = false;                              // positions are lengths, over the drawn ones
  int contacts = 0;
  float mass_kg = 1.0f;   // of the whole plant; forces are measured in its weight
  float length_m = 1.0f;  // of the longest part; heights are measured in it

  [[nodiscard]] PortCount Count() const { return {Actuators(), contacts, muscles}; }
  [[nodiscard]] int Actuators() const { return static_cast<int>(actuator_range.size()); }
};

}  // namespace gaitsmith
