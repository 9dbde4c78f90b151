// SPDX-License-Identifier: MIT
#include "core/control/senses.h"

namespace gaitsmith {

int SenseCount(SenseKind kind, int rods) { return kind == SenseKind::kTimer ? 1 : 2 * rods + 2; }

std::string SenseName(SenseKind kind, int rods, int sense) {
  if (kind == SenseKind::kTimer) return "timer";
  const int joints = rods - 1;
  const int endpoints = rods + 1;
  if (sense < joints) return "angle " + std::to_string(sense + 1);
  if (sense < joints + endpoints) return "force " + std::to_string(sense - joints + 1);
  return sense == joints + endpoints ? "height" : "rise";
}

}  // namespace gaitsmith
