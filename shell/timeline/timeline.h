// SPDX-License-Identifier: MIT
// The timeline: which controller is in charge when. Clips are selected with a click; the border between two
// is dragged.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

void DrawTimeline(Ui&, Session&, const ImRect&);

/// A few words over a place of the timeline. @param within from left to right @param bottom the words'
/// [points]
void DrawBubble(const Ui&, float x, const ImRect& within, float bottom, const std::string& words);

}  // namespace gaitsmith::shell
