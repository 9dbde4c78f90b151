// SPDX-License-Identifier: MIT
// Which parts of a figure are each other's mirror image.
#pragma once

#include <array>

#include "core/physics/figure.h"

namespace gaitsmith {

/// Where the parts of a figure are in its mirror image, joints and endpoints in the skeleton's order.
struct Symmetry {
  std::array<int, kMaxJoints> joint{};      // the joint that does what this one did
  std::array<bool, kMaxJoints> reversed{};  // and whether it turns the other way
  std::array<int, kMaxEndpoints> endpoint{};
};

/// @param figure valid
/// @return an error that says why, for a figure whose mirror image is another one
[[nodiscard]] Result<Symmetry> SymmetryOf(const Figure& figure);

}  // namespace gaitsmith
