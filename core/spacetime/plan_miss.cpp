// SPDX-License-Identifier: MIT
#include "core/spacetime/plan_miss.h"

#include <algorithm>
#include <string>

#include "core/numeric/hundredths.h"

namespace gaitsmith {

namespace {

std::string PathOf(const PlanPart& part) {
  using Kind = PlanPart::Kind;
  const bool stands = part.kind == Kind::kStanceX || part.kind == Kind::kStanceY;
  std::string path(stands ? "plan.stances[" : "plan.keyframes[");
  path += std::to_string(part.index);
  path += "]";
  if (part.kind == Kind::kTurn) path += ".turn_rad";
  if (part.kind == Kind::kJoint || part.kind == Kind::kMarkX || part.kind == Kind::kMarkY) {
    path += part.kind == Kind::kJoint ? ".pose[" : ".marks[";
    path += std::to_string(part.which);
    path += "]";
  }
  if (part.kind == Kind::kMarkX) path += ".x_m";
  if (part.kind == Kind::kMarkY) path += ".y_m";
  return path;
}

}  // namespace

Error ErrorOf(const PlanMiss& miss) {
  const bool angle = miss.part.kind == PlanPart::Kind::kJoint || miss.part.kind == PlanPart::Kind::kTurn;
  // Never none.
  std::string amount = InHundredths(std::max(miss.amount, 0.01));
  amount += angle ? " rad" : " m";
  return {ErrorCode::kStructure, PathOf(miss.part),
          "cannot be met: the nearest motion misses it by " + amount};
}

}  // namespace gaitsmith
