// SPDX-License-Identifier: MIT
// The transition map under the clips: over time, how well the selected clip would do if it took over there.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// What the timeline is higher by for it; 0: there is nothing to show.
[[nodiscard]] float TransitionStripHeight(const Session&);

/// @param clips all of them: the whole motion from left to right. The strip stands below
void DrawTransitionStrip(Ui&, const Session&, const ImRect& clips);

}  // namespace gaitsmith::shell
