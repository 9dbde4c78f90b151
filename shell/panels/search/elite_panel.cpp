// SPDX-License-Identifier: MIT
#include "shell/panels/search/elite_panel.h"

#include <algorithm>
#include <string>

#include "shell/results/elite_map.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr float kAxis = 18.0f;       // space for an axis label
constexpr float kMaxSquare = 72.0f;  // edge of a square
constexpr float kLegible = 26.0f;    // edge from which a pose can be recognised

/// Draws a cell of the map. @return whether it was clicked
bool DrawSquare(Ui& ui, const EliteMap& map, MotionStrips& poses, const ImRect& rect, int height, int slip,
                int turns) {
  const Elite* elite = map.At(height, slip, turns);
  const Palette& p = ui.Ink();
  if (elite == nullptr) {
    ui.Canvas()->AddRectFilled(rect.Min, rect.Max, Mix(p.panel, p.soft, 0.7f), 2.0f);
    return false;
  }
  const std::string id =
      "elite/" + std::to_string(height) + "/" + std::to_string(slip) + "/" + std::to_string(turns);
  const Touch touch = ui.Area(id, rect, Grab::kPress,
                              {.label = Tr("Height {1} m, slip {2} m, turns {3}", map.RangeText(0, height),
                                           map.RangeText(1, slip), map.RangeText(2, turns)),
                               .role = "option",
                               .value = Tr("score {1}", Fixed(elite->score.fitness, 2))});
  const float range = std::max(map.Best() - map.Least(), 1e-6f);
  const float share = (elite->score.fitness - map.Least()) / range;
  const bool legible = rect.GetWidth() + 2.0f >= kLegible;
  // A pose needs contrast to every colour behind it.
  const ImU32 fill = Mix(p.soft, p.accent, legible ? 0.08f + 0.5f * share : 0.15f + 0.85f * share);
  ui.Canvas()->AddRectFilled(rect.Min, rect.Max, fill, 2.0f);
  if (legible && ImGui::IsRectVisible(rect.Min, rect.Max)) {
    const auto motion = [&] { return map.MotionAt(height, slip, turns); };
    ImRect inside = rect;
    inside.Expand(-0.1f * rect.GetWidth());
    if (const MotionStrip* pose = poses.Of(map.CellName(height, slip, turns), motion))
      DrawMotionPose(ui, *pose, inside, fill);
  }
  if (touch.hovered) ui.Canvas()->AddRect(rect.Min, rect.Max, p.ink, 2.0f, 0, 1.5f);
  ui.DrawFocus(touch, rect, 2.0f);
  return touch.pressed;
}

}  // namespace

void DrawEliteMap(Ui& ui, Session& session, EliteMapState& state) {
  const EliteMap& map = *session.Search().Elites();
  const EliteMap::Range heights = map.RangeOf(0), slips = map.RangeOf(1), all_turns = map.RangeOf(2);
  int& turns = state.turns;
  turns = std::clamp(turns, all_turns.first, all_turns.last);
  ui.Paragraph(map.Title(), Type::kNote);
  ui.Paragraph(Tr("The best motion of each style, stronger where it scores more. Click to view."),
               Type::kNote);
  ui.Gap(4.0f);
  int shown = turns + 1;
  if (ui.Number("elites/turns", Tr("Turns {1}", map.RangeText(2, turns)), shown, all_turns.first + 1,
                all_turns.last + 1))
    turns = shown - 1;
  ui.Paragraph(Tr("{1} here, {2} in all.", std::to_string(map.Count(turns)), std::to_string(map.Count())),
               Type::kNote);
  ui.Gap(4.0f);
  // Slip increases to the right, height upwards.
  const float side = ImGui::GetCurrentWindowRead()->Size.x - 2.0f * kPanelPadding - kAxis;
  const float edge = std::floor(std::min(side / static_cast<float>(slips.Count()), kMaxSquare));
  const float high = edge * static_cast<float>(heights.Count());
  const ImRect all = ui.Row(high + kAxis);
  const float left = all.Min.x + kAxis;
  std::optional<Document> wanted;
  {
    const PartScope part = ui.Part("elites/map", "listbox", Tr("Map of styles"));
    for (int height = heights.first; height <= heights.last; ++height) {
      for (int slip = slips.first; slip <= slips.last; ++slip) {
        const ImVec2 at(left + edge * static_cast<float>(slip - slips.first),
                        all.Min.y + edge * static_cast<float>(heights.last - height));
        const ImRect square({at.x + 1.0f, at.y + 1.0f}, {at.x + edge - 1.0f, at.y + edge - 1.0f});
        if (DrawSquare(ui, map, state.poses, square, height, slip, turns))
          wanted = map.MotionAt(height, slip, turns);
      }
    }
  }
  ui.Letters().Draw(ui.Canvas(), Type::kSmall, {left, all.Min.y + high + 0.5f * kAxis}, ui.Ink().second_ink,
                    Tr("Slip, {1} to {2} m →", map.LowText(1), map.HighText(1)));
  ui.Letters().Draw(ui.Canvas(), Type::kSmall, {all.Min.x + kAxis - 5.0f, all.Min.y + 7.0f},
                    ui.Ink().second_ink, "↑", Align::kRight);
  ui.Paragraph(Tr("Height upwards, {1} to {2} m", map.LowText(0), map.HighText(0)), Type::kNote);
  ui.Gap(6.0f);
  if (wanted) session.ShowElite(std::move(*wanted));
}

}  // namespace gaitsmith::shell
