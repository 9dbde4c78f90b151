// SPDX-License-Identifier: MIT
// What of a plan cannot be met.
#pragma once

#include "core/numeric/error.h"

namespace gaitsmith {

/// Something that a plan asks for.
struct PlanPart {
  enum class Kind { kJoint, kTurn, kMarkX, kMarkY, kStanceX, kStanceY };
  Kind kind;
  int index;      // of the keyframe or stance
  int which = 0;  // joint, or place of the keyframe

  bool operator==(const PlanPart&) const = default;
};

/// By how much a motion misses it.
struct PlanMiss {
  PlanPart part;
  double amount;  // [m], or [rad] of joints and turns
};

/// "plan.keyframes[0].marks[1].x_m: cannot be met: every motion misses it by 0.23 m or more"
[[nodiscard]] Error ErrorOf(const PlanMiss&);

}  // namespace gaitsmith
