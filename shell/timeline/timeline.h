// SPDX-License-Identifier: MIT
// The timeline: which controller is active when. Click a clip to select it; drag the border between two clips
// to move it.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

void DrawTimeline(Ui&, Session&, const ImRect&);

/// A short text above a place on the timeline. @param within from left to right @param bottom of the text
/// [points]
void DrawBubble(const Ui&, float x, const ImRect& within, float bottom, const std::string& words);

}  // namespace gaitsmith::shell
