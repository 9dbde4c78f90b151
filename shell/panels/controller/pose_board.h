// SPDX-License-Identifier: MIT
// A rule's target pose, to be bent by its limbs. Each limb turns about its joint, within its limits.
#pragma once

#include "shell/panels/controller/rule_editor.h"

namespace gaitsmith::shell {

struct PoseEdit {
  int joint;
  float angle_rad;
};

/// @param angles   the target, one for each joint
/// @param present  what the joints are now, drawn pale behind it; may be empty
/// @return the limb's new angle, while one is dragged
[[nodiscard]] std::optional<PoseEdit> DrawPoseBoard(Ui&, const Skeleton&, const std::vector<float>& angles,
                                                    const std::vector<float>& present, RuleEditorState&);

}  // namespace gaitsmith::shell
