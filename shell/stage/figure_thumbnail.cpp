// SPDX-License-Identifier: MIT
#include "shell/stage/figure_thumbnail.h"

#include <algorithm>
#include <cmath>

#include "shell/stage/figure_drawing.h"

namespace gaitsmith::shell {

void DrawFigureThumbnail(Ui& ui, const Figure& figure, const ImRect& rect, ImU32 colour, ImU32 behind,
                         float turn_rad) {
  const FigureLook look = LookOf(figure);
  std::vector<ImVec2> points = PoseOf(figure);
  const float sine = std::sin(turn_rad), cosine = std::cos(turn_rad);
  for (ImVec2& point : points) point = {point.x * cosine - point.y * sine, point.x * sine + point.y * cosine};
  ImRect extent(points[0], points[0]);
  for (const ImVec2& point : points) extent.Add(point);
  extent.Min.x -= look.middle_m;
  extent.Max.x += look.middle_m;
  extent.Min.y -= look.sole_m;
  extent.Max.y += look.middle_m;
  const float scale = std::min(rect.GetWidth() / std::max(extent.GetWidth(), 1e-3f),
                               rect.GetHeight() / std::max(extent.GetHeight(), 1e-3f));
  // Align the feet on a common ground line.
  for (ImVec2& point : points) {
    point = {rect.GetCenter().x + (point.x - extent.GetCenter().x) * scale,
             rect.Max.y - (point.y - extent.Min.y) * scale};
  }
  DrawBody(ui.Canvas(), look, points, scale,
           {.body = colour, .far = Mix(behind, colour, kFarShare), .eye = behind});
}

}  // namespace gaitsmith::shell
