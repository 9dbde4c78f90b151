// SPDX-License-Identifier: MIT
// Which parts of a figure mirror each other.
#pragma once

#include <array>

#include "core/physics/figure.h"

namespace gaitsmith {

/// For each part of a figure, its counterpart in the mirror image. Joints and endpoints are in the skeleton's
/// order.
struct Symmetry {
  std::array<int, kMaxJoints> joint{};      // the counterpart of this joint
  std::array<bool, kMaxJoints> reversed{};  // whether the counterpart turns the other way
  std::array<int, kMaxEndpoints> endpoint{};
};

/// @param figure must be valid (see Validate)
/// @return an error with the reason if the figure is not its own mirror image
[[nodiscard]] Result<Symmetry> SymmetryOf(const Figure& figure);

}  // namespace gaitsmith
