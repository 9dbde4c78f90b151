// SPDX-License-Identifier: MIT
// What the limbs of a figure need to move under forces: how the motion of each rod moves all the others, and
// how strong the joints are. Of model 2.
//
// With the directions alpha of the rods and u = (cos alpha, sin alpha), every point of the figure is a sum of
// constant multiples of the u. Seen from the centre of mass, the kinetic energy therefore is
//   T = 1/2 sum_jk A_jk cos(alpha_j - alpha_k) alpha_j' alpha_k'
// with a constant matrix A, and no recursion along the limbs is needed.
#pragma once

#include <array>
#include <cstdint>

#include "core/physics/skeleton.h"

namespace gaitsmith {

struct Mechanism : Skeleton {
  /// Without strength: for measurements of motions that are prescribed.
  explicit Mechanism(const Skeleton&);
  /// @param figure must be valid (see Validate)
  explicit Mechanism(const Figure& figure);

  /// A [kg m^2], symmetric (rods, rods).
  std::array<std::array<float, kMaxRods>, kMaxRods> coupling{};
  /// Centre of mass from the root's start, as multiples of the rods' directions [m].
  std::array<float, kMaxRods> centre{};
  /// Bit mask of the endpoints beyond each joint, by limb; the root has all of them.
  std::array<std::int32_t, kMaxRods> beyond{};
  // By limb; of the joint where it starts. The root's are 0.
  std::array<float, kMaxRods> torque_nm{};      // greatest
  std::array<float, kMaxRods> firmness{};       // stiffness times the effective inertia at rest [kg m^2]
  std::array<float, kMaxRods> stop_firmness{};  // of a joint limit [kg m^2]
};

}  // namespace gaitsmith
