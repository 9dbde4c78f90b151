// SPDX-License-Identifier: MIT
#include "core/rollout/problem.h"

#include "core/rollout/models.h"

namespace gaitsmith {

ControllerShape Problem::Shape() const { return ShapeFor(CountPorts(model, figure)); }

}  // namespace gaitsmith
