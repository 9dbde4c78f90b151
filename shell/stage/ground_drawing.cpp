// SPDX-License-Identifier: MIT
#include "shell/stage/ground_drawing.h"

#include <algorithm>
#include <cmath>

#include "shell/words/wording.h"

namespace gaitsmith::shell {

namespace {

constexpr int kTicksInReach = 120;  // on three stage widths: a tilted stage may show ground on either side

}  // namespace

ImU32 GroundColour(const Palette& p) {
  return Mix(p.paper, p.ground, ImGui::ColorConvertU32ToFloat4(p.ground).w);
}

void DrawGround(Ui& ui, const ImRect& rect, const Camera& camera) {
  const Palette& p = ui.Ink();
  ImDrawList* list = ui.Canvas();
  const double width_m = static_cast<double>(rect.GetWidth() / camera.scale);
  const double first = camera.left_m - width_m;
  const double last = camera.left_m + 2.0 * width_m;
  const ImVec2 left = camera.ToScreen(first, 0.0f);
  const ImVec2 right = camera.ToScreen(last, 0.0f);
  if (camera.sine == 0.0f) {
    if (camera.origin.y < rect.Max.y)
      ui.Behind().Fill({{rect.Min.x, camera.origin.y}, rect.Max}, GroundColour(p));
  } else {
    const float below = rect.Max.y + 0.6f * rect.GetWidth();
    const ImVec2 corners[] = {left, right, {right.x, below}, {left.x, below}};
    list->AddConvexPolyFilled(corners, 4, p.ground);
  }

  // A tick every metre, or every 2, 5, 10 … metres if ticks would be crowded. The loop counts ticks, since
  // far away one metre may be less than the floating-point precision.
  const auto label_of = [](double metres) { return Fixed(metres, 0) + " m"; };
  const float label_width = ui.Letters().Width(Type::kSmall, label_of(std::min(first, -last)));
  const double crowded_m = static_cast<double>(std::max(44.0f, label_width + 8.0f) / camera.scale);
  const double least_m = std::max(crowded_m, (last - first) / kTicksInReach);
  double spacing = 1.0;
  for (int grow = 0; spacing < least_m; ++grow) spacing *= grow % 3 == 1 ? 2.5 : 2.0;
  const double first_tick = std::ceil(first / spacing) * spacing;
  for (int tick = 0; tick <= kTicksInReach; ++tick) {
    const double metres = first_tick + tick * spacing;
    const ImVec2 at = camera.ToScreen(metres, 0.0f);
    if (at.x < rect.Min.x - 30.0f || at.x > rect.Max.x + 30.0f) continue;
    const ImVec2 foot(at.x + 7.0f * camera.sine, at.y + 7.0f * camera.cosine);
    list->AddLine(at, foot, p.second_ink);
    const ImVec2 text(at.x + 19.0f * camera.sine, at.y + 19.0f * camera.cosine);
    const std::string label = label_of(metres);
    // A label that is cut off could be misread: "−1 m" as "1 m".
    const float half = 0.5f * ui.Letters().Width(Type::kSmall, label) + 2.0f;
    if (text.x - half < rect.Min.x || text.x + half > rect.Max.x) continue;
    ui.Letters().Draw(list, Type::kSmall, text, p.second_ink, label, Align::kCentre);
  }
  list->AddLine(left, right, p.second_ink, 1.5f);
}

}  // namespace gaitsmith::shell
