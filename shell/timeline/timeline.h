// SPDX-License-Identifier: MIT
// The timeline: which controller is active when. Click a clip to select it, and drag a border between two
// clips to move the switch.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

void DrawTimeline(Ui&, Session&, const ImRect&);

/// A short text above the timeline. @param x its centre, kept inside `within` @param bottom its lower edge
/// [points]
void DrawBubble(const Ui&, float x, const ImRect& within, float bottom, const std::string& words);

}  // namespace gaitsmith::shell
