// SPDX-License-Identifier: MIT
// Which parts of a figure mirror each other.
#pragma once

#include <array>

#include "core/physics/figure.h"

namespace gaitsmith {

/// For each part of a figure, its counterpart in the mirror image. Joints and endpoints are in the skeleton's
/// order, muscles and nodes in the figure's.
struct Symmetry {
  std::array<int, kMaxActuators> joint{};      // the counterpart of this joint or muscle
  std::array<bool, kMaxActuators> reversed{};  // whether the counterpart turns the other way; no muscle does
  std::array<int, kMaxContacts> endpoint{};    // or node
};

/// @param figure must be valid (see Validate)
/// @return an error with the reason if the figure is not its own mirror image
[[nodiscard]] Result<Symmetry> SymmetryOf(const Figure& figure);

}  // namespace gaitsmith
