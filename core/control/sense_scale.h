// SPDX-License-Identifier: MIT
// What normalised senses are in units: the scales that SenseSpec lists, as numbers.
#pragma once

#include "core/control/senses.h"
#include "core/physics/skeleton.h"

namespace gaitsmith {

enum class SenseQuantity { kAngle, kForce, kHeight, kVelocity, kTime };

struct SenseScale {
  SenseQuantity quantity;
  float at_zero, at_one;  // [rad], [N], [m], [m/s] or [s]

  [[nodiscard]] float Of(float sense) const { return at_zero + (at_one - at_zero) * sense; }
};

/// @param sense in [0, SenseCount())
[[nodiscard]] SenseScale ScaleOf(const SenseSpec&, const Skeleton&, int sense);

}  // namespace gaitsmith
