// SPDX-License-Identifier: MIT
#include "core/control/network.h"

namespace gaitsmith {

std::string InputName(const NetworkShape& shape, int input) {
  if (input < shape.touches) return "touch " + std::to_string(input + 1);
  input -= shape.touches;
  if (input < shape.joints) return "angle " + std::to_string(input + 1);
  return "node " + std::to_string(input - shape.joints + 1);
}

}  // namespace gaitsmith
