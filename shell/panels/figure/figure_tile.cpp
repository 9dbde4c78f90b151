// SPDX-License-Identifier: MIT
#include "shell/panels/figure/figure_tile.h"

#include <algorithm>

#include "shell/stage/figure_drawing.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

void DrawThumbnail(Ui& ui, const Figure& figure, const ImRect& rect, ImU32 colour) {
  const Skeleton bones(figure);
  const FigureLook look = LookOf(figure.name, bones);
  std::vector<ImVec2> points = PoseOf(bones, {});
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
  const ImU32 behind = ui.Ink().panel;
  DrawBody(ui.Canvas(), bones, look, points, scale,
           {.body = colour, .far = Mix(behind, colour, kFarShare), .eye = behind});
}

}  // namespace

bool DrawFigureTile(Ui& ui, const Figure& figure, const std::string& id, bool chosen, const ImRect& rect) {
  const std::string shown = TrTitle(figure.name);
  const Touch touch =
      ui.Area(id, rect, Grab::kPress, {.label = shown, .role = "radio", .state = {.checked = chosen}});
  if (!touch.visible) return touch.pressed;
  const Palette& p = ui.Ink();
  const ImU32 edge = chosen ? p.accent : touch.hovered ? Mix(p.line, p.ink, 0.45f) : p.line;
  ui.Frame(rect, chosen ? Mix(p.panel, p.accent, 0.08f) : p.panel, edge, 9.0f);
  // A long name takes two lines.
  const float room = rect.GetWidth() - 8.0f;
  std::string_view name = shown;
  const std::size_t first = ui.Letters().FitLine(Type::kNote, name, room);
  const bool two_lines = first < name.size();
  const ImU32 ink = chosen ? p.ink : p.second_ink;
  float y = rect.Max.y - (two_lines ? 25.0f : 14.0f);
  DrawThumbnail(ui, figure, {{rect.Min.x + 16.0f, rect.Min.y + 10.0f}, {rect.Max.x - 16.0f, y - 15.0f}},
                chosen ? p.accent : Mix(p.panel, p.ink, 0.85f));
  if (two_lines) {
    ui.Letters().Draw(ui.Canvas(), Type::kNote, {rect.GetCenter().x, y}, ink, name.substr(0, first),
                      Align::kCentre);
    name.remove_prefix(first);
    while (!name.empty() && name.front() == ' ') name.remove_prefix(1);
    y += 14.0f;
  }
  const float width = std::min(room, ui.Letters().Width(Type::kNote, name) + 1.0f);
  ui.Letters().DrawElided(ui.Canvas(), Type::kNote, {rect.GetCenter().x - 0.5f * width, y}, width, ink, name);
  ui.DrawFocus(touch, rect, 9.0f);
  return touch.pressed;
}

}  // namespace gaitsmith::shell
