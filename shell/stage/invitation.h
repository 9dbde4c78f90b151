// SPDX-License-Identifier: MIT
// What the stage says while a figure cannot move yet: a headline, and the button that starts the first
// search.
#pragma once

#include "shell/session/session.h"
#include "shell/stage/camera.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// Whether the figure cannot move yet and nothing runs that would change that.
[[nodiscard]] bool Invites(const Session&);

/// Whether the button is beside the figure, not below it.
[[nodiscard]] bool InvitesBeside(const ImRect& stage);

/// Leaves room for the headline and the button.
[[nodiscard]] Framing InvitationFraming(const ImRect& stage);

void DrawInvitation(Ui&, Session&, const ImRect& stage);

}  // namespace gaitsmith::shell
