// SPDX-License-Identifier: MIT
// A pose of a controller, edited by dragging limbs. Each limb turns about its joint, within its limits.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/physics/skeleton.h"
#include "core/signal/ports.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// The view is fixed while a limb is dragged, so that the limb stays under the pointer.
struct LimbDrag {
  int limb = -1;              // index in the skeleton; -1: none
  float grip_rad = 0.0f;      // angle from the limb to the grabbed point
  float scale = 0.0f;         // [points per metre]
  ImVec2 origin{0.0f, 0.0f};  // canvas position of endpoint 0
};

struct PoseEdit {
  int joint;        // or muscle
  float angle_rad;  // or length, over the drawn one
};

/// @param id       of the widget
/// @param label    for screen readers
/// @param colour   of the limbs
/// @param angles   angle of each joint [rad]
/// @param present  present joint angles [rad], drawn pale behind it; may be empty
/// @return the limb's new angle during a drag
[[nodiscard]] std::optional<PoseEdit> DrawPoseBoard(Ui&, const std::string& id, const std::string& label,
                                                    ImU32 colour, const Skeleton&,
                                                    const std::vector<float>& angles,
                                                    const std::vector<float>& present, LimbDrag&);

/// A slider for the angle of each joint that can move, or the length of each muscle.
/// @param id       of the widgets, before the joint's number
/// @param colours  one for each joint
/// @return the new angle of the one that is moved
[[nodiscard]] std::optional<PoseEdit> DrawAngleSliders(Ui&, const std::string& id, const Ports&,
                                                       const std::vector<float>& angles,
                                                       const std::vector<ImU32>& colours);

}  // namespace gaitsmith::shell
