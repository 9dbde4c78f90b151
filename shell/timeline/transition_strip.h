// SPDX-License-Identifier: MIT
// The transition map under the clips: how well the selected clip would do if it took over at each time.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// Height that the strip adds to the timeline; 0 if there is no strip.
[[nodiscard]] float TransitionStripHeight(const Session&);

/// @param clips area of all clips, covering the whole motion. The strip is below it
void DrawTransitionStrip(Ui&, const Session&, const ImRect& clips);

}  // namespace gaitsmith::shell
