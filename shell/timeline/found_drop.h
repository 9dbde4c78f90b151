// SPDX-License-Identifier: MIT
// Dragging a found motion from its card to the timeline.
#pragma once

#include <string>

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// Makes the last drawn area draggable.
/// @param name  shown at the pointer during the drag
void OfferFound(const Ui&, const std::string& id, const std::string& name);

/// Inserts a motion dropped on the clips: at the pointer, or at a nearby shown moment, border or half second.
/// @param band area of all clips, from the start of the motion to its end
void TakeFound(const Ui&, Session&, const ImRect& band);

}  // namespace gaitsmith::shell
