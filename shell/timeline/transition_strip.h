// SPDX-License-Identifier: MIT
// The transition map under the clips: how well the selected clip would do if it took over at each time.
#pragma once

#include <string>

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// Height that the strip adds to the timeline; 0 if there is no strip.
[[nodiscard]] float TransitionStripHeight(const Session&);

/// "good", "fair" or "poor", of the one verdict
[[nodiscard]] std::string VerdictWords(float share);
/// The share in whole percent.
[[nodiscard]] int PercentOf(float share);

/// @param clips area of all clips, covering the whole motion. The strip is below it
void DrawTransitionStrip(Ui&, const Session&, const ImRect& clips);

}  // namespace gaitsmith::shell
