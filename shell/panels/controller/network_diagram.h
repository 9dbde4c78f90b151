// SPDX-License-Identifier: MIT
// A sensor-actuator network as a diagram: sensors left, hidden nodes in the middle, actuators right.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// @param controller a network, of the selected clip
void DrawNetwork(Ui& ui, const Session& session, const Controller& controller);

}  // namespace gaitsmith::shell
