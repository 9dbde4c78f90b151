// SPDX-License-Identifier: MIT
// Where the points of a figure are, as constant multiples of the directions of its rods, and how the motion
// of each rod moves all the others. See mechanism.h.
#pragma once

#include <array>

#include "core/physics/skeleton.h"

namespace gaitsmith {

struct RodMultiples {
  explicit RodMultiples(const Skeleton&);

  template <int rows>
  using Table = std::array<std::array<double, kMaxRods>, rows>;
  Table<kMaxEndpoints> end{};           // endpoints from the root's start [m] (endpoints, rods)
  std::array<double, kMaxRods> mean{};  // centre of mass from the root's start [m] (rods)
  Table<kMaxRods> coupling{};           // A of mechanism.h [kg m^2], symmetric (rods, rods)
};

}  // namespace gaitsmith
