// SPDX-License-Identifier: MIT
// A found motion that is dragged from its card to the timeline.
#pragma once

#include <string>

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// After the area that is drawn last: it may be dragged away.
/// @param name  what the pointer carries meanwhile
void OfferFound(const Ui&, const std::string& id, const std::string& name);

/// Takes it where it is let go over the clips: it is inserted there, or at the moment
/// shown, the border or the half second nearby.
/// @param band of all clips, from the start of the motion to its end
void TakeFound(const Ui&, Session&, const ImRect& band);

}  // namespace gaitsmith::shell
