// SPDX-License-Identifier: MIT
// A 2D figure: a tree of rigid uniform rods [Fukunaga 1994, section 2], or point masses and springs
// [Christensen Marks Ngo 1997]. n rods have n - 1 joint angles and n + 1 endpoints, as counted in Table 1 of
// the paper.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/numeric/error.h"
#include "core/physics/constants.h"

namespace gaitsmith {

enum class RodEnd { kStart, kEnd };

/// The parent index of the root rod, which has no parent.
inline constexpr int kNoParent = -1;

struct Rod {
  float length_m = 1.0f;   // [0.001, 1000]
  float mass_kg = 1.0f;    // [1e-6, 1e6], spread evenly along the rod
  int parent = kNoParent;  // index of the rod it is attached to; kNoParent for exactly one rod, the root
  RodEnd parent_end = RodEnd::kEnd;  // the end of the parent where this rod starts
  float rest_rad = 0.0f;  // drawn angle relative to the parent (root: to the horizontal), counterclockwise
  float min_rad = -1.0f;  // lower joint limit relative to rest_rad, [-pi, 0]; ignored for the root
  float max_rad = 1.0f;   // upper joint limit relative to rest_rad, [0, pi]; ignored for the root
  // Of the joint to the parent, from model 2 on; ignored for the root.
  float strength = 2.0f;  // greatest torque, in M g L of the figure (L its longest rod), [0, 1000]; 0: limp
  float stiffness =
      10000.0f;  // how firmly an unlimited joint follows its rule, in effective inertias, [1, 1e6]

  bool operator==(const Rod&) const = default;
};

/// A point mass of a figure of springs. Springs hold nodes together, and only nodes touch the ground.
struct Node {
  float x_m = 0.0f, y_m = 0.0f;  // drawn position, [-1000, 1000]
  float mass_kg = 1.0f;          // [1e-6, 1e6]

  bool operator==(const Node&) const = default;
};

/// Pulls its nodes together, or pushes them apart, with stiffness times (length - rest). Damped along its
/// length.
struct Spring {
  int from = 0, to = 1;          // two different nodes
  float stiffness_npm = 500.0f;  // [N/m], [0, 1e6]; see FastestVibration
  float damping_nspm = 1.0f;     // [N s/m], [0, 1e6]
  // Its length without force, over the drawn distance of its nodes. [kLeastRest, kMostRest]
  float rest = 1.0f;
  // The rest that a controller may choose: a muscle if these differ. They contain `rest`.
  float min_rest = 1.0f, max_rest = 1.0f;

  [[nodiscard]] bool IsMuscle() const { return min_rest < max_rest; }
  bool operator==(const Spring&) const = default;
};

/// Of rods, or of nodes and springs (model 3). Never of both.
struct Figure {
  std::string name;
  std::vector<Rod> rods;  // in any order
  std::vector<Node> nodes = {};
  std::vector<Spring> springs = {};

  [[nodiscard]] bool HasSprings() const { return !nodes.empty(); }
  [[nodiscard]] int Muscles() const;
  [[nodiscard]] int Rods() const { return static_cast<int>(rods.size()); }
  [[nodiscard]] int Joints() const { return HasSprings() ? 0 : Rods() - 1; }
  /// What a controller moves: joints, or muscles.
  [[nodiscard]] int Actuators() const { return HasSprings() ? Muscles() : Joints(); }
  /// What has a mass: rods, or nodes.
  [[nodiscard]] int Parts() const { return HasSprings() ? static_cast<int>(nodes.size()) : Rods(); }
  /// What can touch the ground: ends of rods, or nodes.
  [[nodiscard]] int Endpoints() const { return HasSprings() ? static_cast<int>(nodes.size()) : Rods() + 1; }
};

/// A length typical of the figure, by which motions of different figures can be compared [m]: the length of
/// all rods over the root of their number, between those of a star and of a chain. Of springs: the diagonal
/// of the drawn figure.
[[nodiscard]] float SizeOf(const Figure&);

/// A figure's name up to a comma: "Ostrich" of "Ostrich, mirrored". Edited copies keep what their figure is.
[[nodiscard]] constexpr std::string_view KindOf(std::string_view name) {
  return name.substr(0, name.find(','));
}

/// True if both trees have the same number of rods attached to the same ends, whatever their lengths, masses,
/// angles and limits; or as many nodes, and springs and muscles between the same ones. Controllers of one
/// figure can then drive the other.
[[nodiscard]] bool SameTree(const Figure&, const Figure&);

/// Distance of a spring's nodes as drawn [m], at least kShortestSpring in a valid figure.
[[nodiscard]] float DrawnLength(const Figure&, const Spring&);
inline constexpr float kShortestSpring = 0.001f;

/// Bound of the squared frequency of the fastest vibration of a figure of springs [1/s^2], by the rows of its
/// matrix [Gershgorin 1931]: twice the stiffness at a node over its mass, the greatest of all nodes. @param
/// node out: which
[[nodiscard]] float FastestVibration(const Figure&, int* node = nullptr);

/// The part of Validate for a figure of springs.
[[nodiscard]] Result<void> ValidateSprings(const Figure&);

/// Checks that the rods form one tree, or the springs hold all nodes together, and every number is in range.
/// @return nothing, or the first fault: where it is ("rods[2].parent") and what is wrong, in readable words
[[nodiscard]] Result<void> Validate(const Figure&);

}  // namespace gaitsmith
