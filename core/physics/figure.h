// SPDX-License-Identifier: MIT
// A 2D articulated figure: a tree of rigid uniform rods [Fukunaga 1994, section 2]. n rods have n - 1 joint
// angles and n + 1 endpoints, as Table 1 of the paper counts them.
#pragma once

#include <string>
#include <vector>

#include "core/numeric/error.h"
#include "core/physics/constants.h"

namespace gaitsmith {

enum class RodEnd { kStart, kEnd };

/// Index of the root rod's (absent) parent.
inline constexpr int kNoParent = -1;

struct Rod {
  float length_m = 1.0f;             // [0.001, 1000]
  float mass_kg = 1.0f;              // [1e-6, 1e6], spread evenly along the rod
  int parent = kNoParent;            // index of the rod it hangs on; kNoParent for exactly one rod, the root
  RodEnd parent_end = RodEnd::kEnd;  // the end of the parent where this rod starts
  float rest_rad = 0.0f;  // drawn angle against the parent (root: against horizontal), anticlockwise
  float min_rad = -1.0f;  // joint limits against rest_rad, [-pi, 0] and [0, pi];
  float max_rad = 1.0f;   // the root has no joint and ignores them

  bool operator==(const Rod&) const = default;
};

struct Figure {
  std::string name;
  std::vector<Rod> rods;  // in any order

  [[nodiscard]] int Rods() const { return static_cast<int>(rods.size()); }
  [[nodiscard]] int Joints() const { return Rods() - 1; }
  [[nodiscard]] int Endpoints() const { return Rods() + 1; }
};

/// As many rods hang on the same ends, whatever their lengths, masses, angles and limits: controllers of one
/// figure can drive the other.
[[nodiscard]] bool SameTree(const Figure&, const Figure&);

/// Checks that the rods form one tree and every number is in range.
/// @return nothing, or the first fault: where it is ("rods[2].parent") and what is wrong, for a person to
/// read.
[[nodiscard]] Result<void> Validate(const Figure&);

}  // namespace gaitsmith
