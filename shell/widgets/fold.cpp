// SPDX-License-Identifier: MIT
#include "shell/widgets/fold.h"

#include <algorithm>

namespace gaitsmith::shell {

bool DrawFold(Ui& ui, std::string_view id, std::string_view title, std::string_view note, bool& open) {
  ui.Gap(4.0f);
  const ImRect row = ui.ControlRow();
  const Touch touch = ui.Area(id, row, Grab::kPress,
                              {.label = std::string(title),
                               .role = "button",
                               .value = std::string(note),
                               .state = {.expanded = open}});
  if (touch.pressed) open = !open;
  if (!touch.visible) return open;
  const Palette& p = ui.Ink();
  const Fonts& letters = ui.Letters();
  ImDrawList* list = ui.Canvas();
  const float y = row.GetCenter().y;
  ui.HorizontalLine(row.Min.x, row.Max.x, row.Min.y - 1.0f);
  const ImU32 ink = touch.hovered ? p.ink : p.second_ink;
  const ImVec2 arrow(row.Min.x + 5.0f, y);
  const float size = 3.5f;
  if (open) {
    list->PathLineTo({arrow.x - size, arrow.y - 0.5f * size});
    list->PathLineTo({arrow.x, arrow.y + 0.5f * size});
    list->PathLineTo({arrow.x + size, arrow.y - 0.5f * size});
  } else {
    list->PathLineTo({arrow.x - 0.5f * size, arrow.y - size});
    list->PathLineTo({arrow.x + 0.5f * size, arrow.y});
    list->PathLineTo({arrow.x - 0.5f * size, arrow.y + size});
  }
  list->PathStroke(ink, 0, 1.6f);
  const float left = row.Min.x + 17.0f;
  const float title_width = letters.Width(Type::kStrong, title);
  letters.Draw(list, Type::kStrong, {left, y}, p.ink, title);
  const float room = row.Max.x - left - title_width - 14.0f;
  const float width = std::min(room, letters.Width(Type::kNote, note));
  letters.DrawElided(list, Type::kNote, {row.Max.x - width, y}, width + 1.0f, p.second_ink, note);
  ui.DrawFocus(touch, row);
  return open;
}

}  // namespace gaitsmith::shell
