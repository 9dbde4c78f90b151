// SPDX-License-Identifier: MIT
// The scales that convert a figure's normalised senses to physical units.
#pragma once

#include "core/control/sense_table.h"
#include "core/physics/skeleton.h"

namespace gaitsmith {

/// @param sense in [0, SenseCount())
[[nodiscard]] inline SenseScale ScaleOf(const SenseSpec& spec, const Skeleton& bones, int sense) {
  return ScaleOf(spec, PortsOf(bones), sense);
}

}  // namespace gaitsmith
