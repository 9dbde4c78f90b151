// SPDX-License-Identifier: MIT
#include "shell/panels/figure/figure_tile.h"

#include <algorithm>

#include "shell/stage/figure_thumbnail.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
float DrawTileName(Ui& ui, std::string_view name, const ImRect& tile, ImU32 ink) {
  constexpr float kLine = 14.0f;
  const Fonts& letters = ui.Letters();
  const float room = tile.GetWidth() - 8.0f;
  const float x = tile.GetCenter().x;
  const std::size_t first = letters.FitLine(Type::kNote, name, room);
  const bool two_lines = first < name.size();
  const float top = tile.Max.y - (two_lines ? 25.0f : 14.0f);
  float y = top;
  if (two_lines) {
    letters.Draw(ui.Canvas(), Type::kNote, {x, y}, ink, name.substr(0, first), Align::kCentre);
    name.remove_prefix(first);
    while (!name.empty() && name.front() == ' ') name.remove_prefix(1);
    y += kLine;
  }
  const float width = std::min(room, letters.Width(Type::kNote, name) + 1.0f);
  letters.DrawElided(ui.Canvas(), Type::kNote, {x - 0.5f * width, y}, width, ink, name);
  return top - 15.0f;
}

bool DrawFigureTile(Ui& ui, const Figure& figure, const std::string& id, bool chosen, const ImRect& rect) {
  const std::string shown = TrTitle(figure.name);
  const Touch touch =
      ui.Area(id, rect, Grab::kPress, {.label = shown, .role = "radio", .state = {.checked = chosen}});
  if (!touch.visible) return touch.pressed;
  const Palette& p = ui.Ink();
  const ImU32 fill = ui.CardFrame(rect, chosen, touch.hovered);
  const ImU32 ink = chosen ? p.ink : p.second_ink;
  const float above = DrawTileName(ui, shown, rect, ink);
  DrawFigureThumbnail(ui, figure, {{rect.Min.x + 16.0f, rect.Min.y + 10.0f}, {rect.Max.x - 16.0f, above}},
                      chosen ? p.accent : Mix(p.panel, p.ink, 0.85f), fill);
  ui.DrawFocus(touch, rect, 9.0f);
  return touch.pressed;
}

}  // namespace gaitsmith::shell
