// SPDX-License-Identifier: MIT
// The mirror image of a controller: what it does to the right, its image does to the left. Only a figure that
// is its own mirror image as it is drawn (Mr. Star-Man, a worm, not a horse) can follow it.
#pragma once

#include "core/control/controller.h"
#include "core/physics/figure.h"

namespace gaitsmith {

/// Its name says that it is mirrored. @param controller rules, for this figure
/// @return an error for a network (its sensors cannot feel the opposite) or where SymmetryOf has one
[[nodiscard]] Result<Controller> MirrorImageOf(const Controller& controller, const Figure& figure);

}  // namespace gaitsmith
