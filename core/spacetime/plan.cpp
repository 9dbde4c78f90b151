// SPDX-License-Identifier: MIT
#include "core/spacetime/plan.h"

#include <string>

namespace gaitsmith {

namespace {

std::string Indexed(std::string_view list, std::size_t index) {
  std::string text("plan.");
  text += list;
  text += "[";
  text += std::to_string(index);
  text += "]";
  return text;
}

Result<void> CheckEndpoint(int endpoint, int least, const Skeleton& skeleton, std::string where) {
  if (endpoint >= least && endpoint < skeleton.endpoints) return {};
  return Fail(ErrorCode::kOutOfRange, std::move(where) + ".endpoint",
              "must be from " + std::to_string(least) + " to " + std::to_string(skeleton.endpoints - 1) +
                  ", is " + std::to_string(endpoint));
}

}  // namespace

Result<void> Validate(const Plan& plan, const Skeleton& skeleton) {
  const int steps = plan.steps;
  for (std::size_t i = 0; i < plan.keyframes.size(); ++i) {
    const Keyframe& keyframe = plan.keyframes[i];
    const std::string where = Indexed("keyframes", i);
    const int least = i == 0 ? 1 : plan.keyframes[i - 1].step;
    if (keyframe.step < least || keyframe.step > steps)
      return Fail(ErrorCode::kOutOfRange, where + ".step",
                  "must be from " + std::to_string(least) + " to " + std::to_string(steps) + ", is " +
                      std::to_string(keyframe.step));
    if (!keyframe.pose_rad.empty() && static_cast<int>(keyframe.pose_rad.size()) != skeleton.joints)
      return Fail(ErrorCode::kStructure, where + ".pose",
                  "must have an angle for each of the " + std::to_string(skeleton.joints) + " joints, has " +
                      std::to_string(keyframe.pose_rad.size()));
    for (std::size_t p = 0; p < keyframe.marks.size(); ++p) {
      if (auto checked = CheckEndpoint(keyframe.marks[p].endpoint, kCentreOfMass, skeleton,
                                       where + ".marks[" + std::to_string(p) + "]");
          !checked)
        return checked;
    }
  }
  for (std::size_t i = 0; i < plan.stances.size(); ++i) {
    const Stance& stance = plan.stances[i];
    const std::string where = Indexed("stances", i);
    if (auto checked = CheckEndpoint(stance.endpoint, 0, skeleton, where); !checked) return checked;
    if (stance.last_step <= stance.first_step || stance.last_step > steps)
      return Fail(ErrorCode::kOutOfRange, where + ".last_step",
                  "must be from " + std::to_string(stance.first_step + 1) + " to " + std::to_string(steps) +
                      ", is " + std::to_string(stance.last_step));
    for (std::size_t other = 0; other < i; ++other) {
      const Stance& before = plan.stances[other];
      if (before.endpoint == stance.endpoint && stance.first_step <= before.last_step &&
          before.first_step <= stance.last_step)
        return Fail(ErrorCode::kStructure, where,
                    "stands when " + Indexed("stances", other) + " already does");
    }
  }
  return {};
}

}  // namespace gaitsmith
