// SPDX-License-Identifier: MIT
#include "shell/timeline/time_ruler.h"

#include <algorithm>

#include "shell/timeline/transport.h"

namespace gaitsmith::shell {

float TimeRuler::XOf(double time_s) const {
  return left + static_cast<float>(std::clamp(time_s / seconds, 0.0, 1.0)) * (right - left);
}

double TimeRuler::TimeAt(float x) const {
  return static_cast<double>(std::clamp((x - left) / std::max(right - left, 1.0f), 0.0f, 1.0f)) * seconds;
}

TimeRuler RulerOf(const Ui& ui, const Session& session, const ImRect& bar, bool whole_width) {
  const double seconds = std::max(1, session.Doc().duration_steps) * static_cast<double>(kStep);
  if (whole_width) return {bar.Min.x + kPanelPadding, bar.Max.x - kPanelPadding, seconds};
  const TransportLayout layout = LayoutOf(ui, session.Player(), bar);
  return {layout.time_end + 10.0f, layout.end_start - 10.0f, seconds};
}

}  // namespace gaitsmith::shell
