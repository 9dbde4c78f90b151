// SPDX-License-Identifier: MIT
// The mirror image of a controller does to the left what the controller does to the right. Only a figure
// whose drawing is its own mirror image (Mr. Star-Man or a worm, but not a horse) can follow it.
#pragma once

#include "core/control/controller.h"
#include "core/physics/figure.h"

namespace gaitsmith {

/// The name of the result says that it is mirrored.
/// @param controller a controller of rules for this figure
/// @return an error for a network, whose sensors cannot sense the opposite, and whenever SymmetryOf returns
/// one
[[nodiscard]] Result<Controller> MirrorImageOf(const Controller& controller, const Figure& figure);

}  // namespace gaitsmith
