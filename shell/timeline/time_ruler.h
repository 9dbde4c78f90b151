// SPDX-License-Identifier: MIT
// Where moments of the motion lie on the screen. The scrubber and the clips below it share this ruler, so a
// moment has the same x in both.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct TimeRuler {
  float left, right;  // start and end of the motion [points]
  double seconds;     // length of the motion, also if its simulation failed earlier

  [[nodiscard]] float XOf(double time_s) const;
  /// Clamped to the motion.
  [[nodiscard]] double TimeAt(float x) const;
};

/// @param bar the transport bar, or an area of the same left and right edge
/// @param whole_width  whether the ruler takes the bar's width; otherwise buttons lie beside it
[[nodiscard]] TimeRuler RulerOf(const Ui&, const Session&, const ImRect& bar, bool whole_width);
/// Whether a bar is too narrow for buttons beside the ruler.
[[nodiscard]] inline bool IsNarrowRuler(float width) { return width < 560.0f; }

}  // namespace gaitsmith::shell
