// SPDX-License-Identifier: MIT
// How a recorded motion uses the ground. This distinguishes a cartwheel from a somersault.
#pragma once

#include "core/rollout/motion.h"

namespace gaitsmith {

struct GroundUse {
  float share = 0.0f;  // share of the steps in which any endpoint bears load, [0, 1]
  int bearers = 0;     // number of endpoints that bear load in at least a hundredth of the steps
};

[[nodiscard]] GroundUse GroundUseOf(const Motion&);

}  // namespace gaitsmith
