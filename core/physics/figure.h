// SPDX-License-Identifier: MIT
// A 2D articulated figure: a tree of rigid uniform rods [Fukunaga 1994, section 2]. n rods have n - 1 joint
// angles and n + 1 endpoints, as counted in Table 1 of the paper.
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

struct Figure {
  std::string name;
  std::vector<Rod> rods;  // in any order

  [[nodiscard]] int Rods() const { return static_cast<int>(rods.size()); }
  [[nodiscard]] int Joints() const { return Rods() - 1; }
  [[nodiscard]] int Endpoints() const { return Rods() + 1; }
};

/// A length typical of the figure, by which motions of different figures can be compared [m]: the length of
/// all rods over the root of their number, between those of a star and of a chain.
[[nodiscard]] float SizeOf(const Figure&);

/// A figure's name up to a comma: "Ostrich" of "Ostrich, mirrored". Edited copies keep what their figure is.
[[nodiscard]] constexpr std::string_view KindOf(std::string_view name) {
  return name.substr(0, name.find(','));
}

/// True if both trees have the same number of rods attached to the same ends, whatever their lengths, masses,
/// angles and limits. Controllers of one figure can then drive the other.
[[nodiscard]] bool SameTree(const Figure&, const Figure&);

/// Checks that the rods form one tree and every number is in range.
/// @return nothing, or the first fault: where it is ("rods[2].parent") and what is wrong, in readable words
[[nodiscard]] Result<void> Validate(const Figure&);

}  // namespace gaitsmith
