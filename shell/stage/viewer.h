// SPDX-License-Identifier: MIT
// What the stage shows to a person who received a link: title, distance, a hint, and the way to the
// workbench.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// Title, distance and time at the stage's top. @return y of the line below
float DrawViewerWords(Ui&, const Session&, const ImRect& stage);

/// The buttons on the ground. @return whether the rules should be shown
[[nodiscard]] bool DrawViewerActions(Ui&, Session&, const ImRect& row);

}  // namespace gaitsmith::shell
