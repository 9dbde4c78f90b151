// SPDX-License-Identifier: MIT
// The mirror image of a controller: what it does to the right, its image does to the left. Only a figure that
// is its own mirror image as it is drawn (Mr. Star-Man, a worm, not a horse) can follow it.
#pragma once

#include <array>

#include "core/control/controller.h"
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

/// Its name says that it is mirrored. @param controller rules, for this figure
/// @return an error for a network (its sensors cannot feel the opposite) or where SymmetryOf has one
[[nodiscard]] Result<Controller> MirrorImageOf(const Controller& controller, const Figure& figure);

}  // namespace gaitsmith
