// SPDX-License-Identifier: MIT
// Play, step, scrub and speed, with a strip that shows the active rule over time.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// Height of the bar. @param low whether the canvas is too low for two rows
[[nodiscard]] float TransportHeight(const Theme&, float width, bool low);

/// Horizontal places in a bar whose buttons lie beside the ruler [points].
struct TransportLayout {
  float time_end;   // right edge of the present time
  float end_start;  // left edge of the motion's length
};
[[nodiscard]] TransportLayout LayoutOf(const Ui&, const Playback&, const ImRect& bar);

/// The ruler has a row of its own if the bar is as high as two rows.
void DrawTransport(Ui&, Session&, const ImRect&);

}  // namespace gaitsmith::shell
