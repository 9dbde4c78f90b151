// SPDX-License-Identifier: MIT
// The row of buttons on the ground: stop a search and keep what it found, and what to do with a found motion.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// Whether the stage has room for buttons, and the arrangement lets a person search.
[[nodiscard]] bool HasStageActions(const Session&, const ImRect& stage);

/// The place of the buttons, on the ground.
[[nodiscard]] ImRect ActionRow(const Ui&, const Session&, const ImRect& stage, float ground_y);

void DrawStageActions(Ui&, Session&, const ImRect& row);

}  // namespace gaitsmith::shell
