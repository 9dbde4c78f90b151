// SPDX-License-Identifier: MIT
// A small plot of several step curves on axes with a few round ticks.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct PlotPoint {
  double x;
  double y;
};

/// Spread of values, constant until the next entry.
struct PlotSpread {
  double x;
  double low;
  double high;
};

struct PlotSeries {
  std::string_view name;
  std::span<const PlotPoint> points;  // x ascending; each y is constant until the next point
  ImU32 colour;
  std::span<const PlotSpread> spread = {};  // a band behind the lines, x ascending
  bool thin = false;                        // a fine background line without a mark at its end
  bool dashed = false;                      // tells it from a solid line of the same colour
};

struct PlotAxes {
  double x_end = 1.0;        // the x axis is [0, x_end]
  std::string_view x_label;  // e.g. "evaluations"
  std::string_view y_unit;   // follows each tick's number, e.g. " m"
};

/// Three or four round numbers within [low, high], low < high.
[[nodiscard]] std::vector<double> NiceTicks(double low, double high);

/// A short piece of a series' line, for legends. The sample is centred, and kLineSample wide.
inline constexpr float kLineSample = 16.0f;
void DrawLineSample(ImDrawList*, ImVec2 centre, ImU32 colour, bool dashed);

/// @param summary text for screen readers, e.g. "best 5.31 after 13,600 evaluations"
void DrawPlot(Ui&, std::string_view id, std::string_view label, const ImRect&, const PlotAxes&,
              std::span<const PlotSeries>, std::string_view summary);

}  // namespace gaitsmith::shell
