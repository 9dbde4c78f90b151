// SPDX-License-Identifier: MIT
// Buttons on the stage: teach the figure, stop and keep, and what to do with a motion that was found.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// Whether the stage says that the figure cannot move yet, and offers to teach it.
[[nodiscard]] bool Invites(const Session&);

/// Whether the stage has room for buttons, and the arrangement lets a person search.
[[nodiscard]] bool HasStageActions(const Session&, const ImRect& stage);

/// Height of the ground below the ground line [points].
[[nodiscard]] float GroundRoom(const Session&, const ImRect& stage);

/// Headline, and the button that starts the first search.
void DrawInvitation(Ui&, Session&, const ImRect& stage);

/// The row of buttons on the ground, while a search runs and after it.
void DrawStageActions(Ui&, Session&, const ImRect& stage);

}  // namespace gaitsmith::shell
