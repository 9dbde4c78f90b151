// SPDX-License-Identifier: MIT
// The timeline: which controller is in charge when. Clips are selected with a click; the border between two
// is dragged.
#pragma once

#include "shell/session.h"
#include "shell/widgets.h"

namespace gaitsmith::shell {

void DrawTimeline(Ui&, Session&, const ImRect&);

}  // namespace gaitsmith::shell
