// SPDX-License-Identifier: MIT
// A rule's target pose, edited by dragging limbs. Each limb turns about its joint, within its limits.
#pragma once

#include "shell/panels/controller/rule_editor.h"

namespace gaitsmith::shell {

struct PoseEdit {
  int joint;
  float angle_rad;
};

/// @param angles   target angle of each joint [rad]
/// @param present  present joint angles [rad], drawn pale behind the target; may be empty
/// @return the limb's new angle during a drag
[[nodiscard]] std::optional<PoseEdit> DrawPoseBoard(Ui&, const Skeleton&, const std::vector<float>& angles,
                                                    const std::vector<float>& present, RuleEditorState&);

}  // namespace gaitsmith::shell
