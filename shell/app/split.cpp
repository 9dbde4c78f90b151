// SPDX-License-Identifier: MIT
#include "shell/app/split.h"

#include <algorithm>

#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {

float Split::Size(float usual, float least, float most) const {
  return std::clamp(size > 0.0f ? size : usual, least, std::max(least, most));
}

void DrawSplit(Ui& ui, Split& split, const SplitPlace& at, float least, float most) {
  constexpr float kStepPoints = 4.0f;
  const float half = ui.Look().touch ? 9.0f : 4.0f;
  const float length = std::min(at.last - at.first, ui.Look().touch ? 64.0f : 1e6f);
  const float middle = 0.5f * (at.first + at.last);
  const ImRect along({middle - 0.5f * length, at.border - half}, {middle + 0.5f * length, at.border + half});
  const ImRect rect =
      at.upright ? ImRect({at.border - half, along.Min.x}, {at.border + half, along.Max.x}) : along;
  const float now = at.edge - at.border;
  const Touch touch =
      ui.Area("panel/split", rect, Grab::kArrows,
              {.label = Tr("Room for the panel"),
               .role = "slider",
               .value = Fixed(now, 0),
               .range = WidgetRange{static_cast<double>(least), static_cast<double>(most),
                                    static_cast<double>(kStepPoints), static_cast<double>(now)}});
  if (touch.hovered || touch.held)
    ImGui::SetMouseCursor(at.upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
  float wanted = now - kStepPoints * static_cast<float>(touch.steps);
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  if (touch.held && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2.0f))
    wanted = at.edge - (at.upright ? pointer.x : pointer.y);
  if (touch.wanted) wanted = static_cast<float>(*touch.wanted);
  if (wanted != now) split.size = std::clamp(wanted, least, std::max(least, most));
  const bool lit = touch.hovered || touch.held;
  if (ui.Look().touch || lit) {  // a grip
    const ImVec2 centre = rect.GetCenter();
    const ImVec2 reach = at.upright ? ImVec2(1.5f, 18.0f) : ImVec2(18.0f, 1.5f);
    ui.Canvas()->AddRectFilled({centre.x - reach.x, centre.y - reach.y},
                               {centre.x + reach.x, centre.y + reach.y},
                               lit ? ui.Ink().accent : ui.Ink().second_ink, 1.5f);
  }
  ui.DrawFocus(touch, rect, 4.0f);
}

}  // namespace gaitsmith::shell
