// SPDX-License-Identifier: MIT
// Scaling, ticks and lines of the curve plot.
#include "shell/widgets/plot.h"

#include <algorithm>
#include <cmath>

#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

// A short tick label: "0", "10k", "2.5M".
std::string Short(double value, double spacing) {
  const double size = std::abs(value);
  const double unit = size >= 1e6 ? 1e6 : size >= 1e4 ? 1e3 : 1.0;
  // The decimals of the spacing, so that all labels have the same number of decimals.
  int digits = 0;
  for (double step = spacing / unit; digits < 2 && std::abs(step - std::round(step)) > 1e-6; step *= 10.0)
    ++digits;
  return Fixed(value / unit, digits) + (size >= 1e6 ? "M" : size >= 1e4 ? "k" : "");
}

constexpr float kDash = 7.0f, kDashGap = 4.0f;

/// Strokes a path with dashes, whose lengths go on around corners.
void StrokeDashed(ImDrawList* list, std::span<const ImVec2> path, ImU32 colour, float thickness) {
  bool draws = true;
  float left = kDash;  // of this dash or gap
  list->PathLineTo(path.front());
  for (std::size_t i = 1; i < path.size(); ++i) {
    ImVec2 from = path[i - 1];
    const ImVec2 to = path[i];
    float length = std::hypot(to.x - from.x, to.y - from.y);
    while (length > left) {
      from = {from.x + (to.x - from.x) * left / length, from.y + (to.y - from.y) * left / length};
      length -= left;
      list->PathLineTo(from);  // ends this dash, or begins the next one
      if (draws) list->PathStroke(colour, 0, thickness);
      draws = !draws;
      left = draws ? kDash : kDashGap;
    }
    left -= length;
    if (draws) list->PathLineTo(to);
  }
  if (draws) list->PathStroke(colour, 0, thickness);
}

struct Extent {
  double low;
  double high;
};

Extent ExtentOf(std::span<const PlotSeries> series) {
  Extent extent{0.0, 0.0};
  for (const PlotSeries& one : series) {
    for (const PlotPoint& point : one.points) {
      extent.low = std::min(extent.low, point.y);
      extent.high = std::max(extent.high, point.y);
    }
    for (const PlotSpread& spread : one.spread) {
      extent.low = std::min(extent.low, spread.low);
      extent.high = std::max(extent.high, spread.high);
    }
  }
  if (extent.high - extent.low < 1e-6) extent.high = extent.low + 1.0;
  extent.high += 0.06 * (extent.high - extent.low);
  return extent;
}

}  // namespace

std::vector<double> NiceTicks(double low, double high) {
  const double rough = (high - low) / 3.5;
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  double spacing = 10.0 * decade;
  for (const double factor : {5.0, 2.5, 2.0, 1.0}) {
    if (factor * decade >= rough) spacing = factor * decade;
  }
  std::vector<double> ticks;
  for (double tick = std::ceil(low / spacing) * spacing; tick <= high + 1e-9 * spacing; tick += spacing) {
    ticks.push_back(std::abs(tick) < 1e-9 * spacing ? 0.0 : tick);
  }
  return ticks;
}

void DrawLineSample(ImDrawList* list, ImVec2 centre, ImU32 colour, bool dashed) {
  constexpr float kThick = 4.0f, kGap = 4.0f;
  const ImVec2 low(centre.x - 0.5f * kLineSample, centre.y - 0.5f * kThick);
  const ImVec2 high(centre.x + 0.5f * kLineSample, centre.y + 0.5f * kThick);
  if (!dashed) return list->AddRectFilled(low, high, colour, 1.0f);
  list->AddRectFilled(low, {centre.x - 0.5f * kGap, high.y}, colour, 1.0f);
  list->AddRectFilled({centre.x + 0.5f * kGap, low.y}, high, colour, 1.0f);
}

void DrawPlot(Ui& ui, std::string_view id, std::string_view label, const ImRect& rect, const PlotAxes& axes,
              std::span<const PlotSeries> series, std::string_view summary) {
  const Touch touch = ui.Area(id, rect, Grab::kPress,
                              {.label = std::string(label), .role = "img", .value = std::string(summary)});
  if (!touch.visible) return;
  const Palette& p = ui.Ink();
  const Fonts& letters = ui.Letters();
  ImDrawList* list = ui.Canvas();

  const Extent extent = ExtentOf(series);
  const std::vector<double> ticks = NiceTicks(extent.low, extent.high);
  const double spacing = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
  float margin = 0.0f;
  for (const double tick : ticks) {
    margin = std::max(margin, letters.Width(Type::kSmall, Short(tick, spacing) + std::string(axes.y_unit)));
  }
  const ImRect field({rect.Min.x + margin + 8.0f, rect.Min.y + 8.0f},
                     {rect.Max.x - 4.0f, rect.Max.y - 22.0f});
  const auto x_of = [&](double x) {
    return field.Min.x + static_cast<float>(std::clamp(x / axes.x_end, 0.0, 1.0)) * field.GetWidth();
  };
  const auto y_of = [&](double y) {
    return field.Max.y -
           static_cast<float>((y - extent.low) / (extent.high - extent.low)) * field.GetHeight();
  };

  for (const double tick : ticks) {
    const float y = y_of(tick);
    ui.HorizontalLine(field.Min.x, field.Max.x, y);
    letters.Draw(list, Type::kSmall, {field.Min.x - 7.0f, y}, p.second_ink,
                 Short(tick, spacing) + std::string(axes.y_unit), Align::kRight);
  }
  const std::vector<double> x_ticks = NiceTicks(0.0, axes.x_end);
  // From the right, since the last label has the unit and may leave no room for the previous one.
  float free = rect.Max.x;
  for (std::size_t i = x_ticks.size(); i-- > 0;) {
    const bool last = i + 1 == x_ticks.size();
    const std::string text = Short(x_ticks[i], x_ticks.size() > 1 ? x_ticks[1] : 1.0) +
                             (last ? " " + std::string(axes.x_label) : "");
    const float half = 0.5f * letters.Width(Type::kSmall, text);
    const float x = last ? std::min(x_of(x_ticks[i]), rect.Max.x - half) : x_of(x_ticks[i]);
    if (x + half > free) continue;
    free = x - half - 6.0f;
    letters.Draw(list, Type::kSmall, {x, field.Max.y + 12.0f}, p.second_ink, text, Align::kCentre);
  }

  // Bands lie behind all lines. Each value holds until the next one's x.
  for (const PlotSeries& one : series) {
    for (std::size_t i = 0; i + 1 < one.spread.size(); ++i) {
      const PlotSpread& here = one.spread[i];
      list->AddRectFilled({x_of(here.x), y_of(here.high)}, {x_of(one.spread[i + 1].x), y_of(here.low)},
                          Fade(one.colour, 0.18f));
    }
  }

  // Drawn as steps: the best score is constant between improvements.
  std::vector<ImVec2> path;
  for (const PlotSeries& one : series) {
    if (one.points.empty()) continue;
    path.assign(1, {x_of(one.points.front().x), y_of(one.points.front().y)});
    for (std::size_t i = 1; i < one.points.size(); ++i) {
      const float x = x_of(one.points[i].x);
      const bool rises = one.points[i].y != one.points[i - 1].y;
      // Skip steps less than half a canvas point wide.
      if ((!rises || x - path.back().x < 0.5f) && i + 1 < one.points.size()) continue;
      path.emplace_back(x, y_of(one.points[i - 1].y));
      if (rises) path.emplace_back(x, y_of(one.points[i].y));
    }
    const float thickness = one.thin ? 1.2f : 2.0f;
    if (one.dashed) {
      StrokeDashed(list, path, one.colour, thickness);
    } else {
      list->AddPolyline(path.data(), static_cast<int>(path.size()), one.colour, 0, thickness);
    }
    if (!one.thin) list->AddCircleFilled({path.back().x, y_of(one.points.back().y)}, 3.5f, one.colour);
  }
  ui.DrawFocus(touch, rect);
}

}  // namespace gaitsmith::shell
