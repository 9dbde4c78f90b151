// SPDX-License-Identifier: MIT
#include "shell/panels/make/goal_chips.h"

#include <algorithm>
#include <optional>
#include <string>

#include "shell/panels/make/goal_picture.h"
#include "shell/words/goal_words.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

constexpr float kOneRow = 560.0f;   // wider panels have all in one row
constexpr float kMaxAspect = 1.5f;  // of a picture
constexpr float kSpacing = 8.0f;
constexpr float kChipHeight = 90.0f;
constexpr float kLabelRoom = 24.0f;

/// @return whether it was pressed. @param pointed  set if the pointer or the focus is on it
bool DrawChip(Ui& ui, Goal goal, const Figure& figure, bool chosen, const ImRect& rect, bool& pointed) {
  const bool offered = Offers(goal, figure.name);
  const std::string label = Tr(WordsOf(goal).label);
  const Touch touch =
      ui.Area("goal/" + std::string(kGoalNames[static_cast<std::size_t>(goal)]), rect, Grab::kPress,
              {.label = label,
               .role = "radio",
               .why_not = offered ? "" : WhyNotOffered(goal, figure.name),
               .state = {.checked = chosen}},
              offered);
  pointed |= touch.focused || ImGui::IsMouseHoveringRect(rect.Min, rect.Max);
  if (!touch.visible) return touch.pressed;
  const Palette& p = ui.Ink();
  const ImU32 fill = ui.CardFrame(rect, chosen, touch.hovered);
  const float strength = offered ? 1.0f : 0.35f;
  const float height = kChipHeight - kLabelRoom - 10.0f;
  const float width = std::min(rect.GetWidth() - 18.0f, kMaxAspect * height);
  const ImVec2 corner(rect.GetCenter().x - 0.5f * width, rect.Min.y + 9.0f);
  DrawGoalPicture(
      ui, goal, figure, {corner, {corner.x + width, corner.y + height}},
      {.figure = Mix(fill, p.ink, strength), .mark = Mix(fill, p.accent, strength), .behind = fill});
  const Type type = chosen ? Type::kStrong : Type::kBody;
  ui.Letters().DrawElided(
      ui.Canvas(), type,
      {rect.GetCenter().x - 0.5f * std::min(ui.Letters().Width(type, label) + 1.0f, rect.GetWidth() - 6.0f),
       rect.Max.y - 0.5f * kLabelRoom + 1.0f},
      rect.GetWidth() - 6.0f, offered ? p.ink : p.second_ink, label);
  ui.DrawFocus(touch, rect, 9.0f);
  return touch.pressed && !chosen;
}

}  // namespace

void DrawGoalChips(Ui& ui, Session& session) {
  const Figure& figure = session.Doc().figure;
  const auto chosen = GoalOf(session.Doc());
  std::optional<Goal> pressed, pointed;
  {
    const PartScope group = ui.Part("goals", "radiogroup", Tr("Goal"));
    const int columns = ImGui::GetContentRegionAvail().x >= kOneRow ? kGoals : kGoals / 2;
    ImRect row;
    for (int i = 0; i < kGoals; ++i) {
      const int column = i % columns;
      if (column == 0) {
        if (i > 0) ui.Gap(kSpacing);
        row = ui.Row(kChipHeight);
      }
      const float width = (row.GetWidth() + kSpacing) / static_cast<float>(columns) - kSpacing;
      const float x = row.Min.x + static_cast<float>(column) * (width + kSpacing);
      const auto goal = static_cast<Goal>(i);
      bool here = false;
      if (DrawChip(ui, goal, figure, chosen == goal, {{x, row.Min.y}, {x + width, row.Max.y}}, here))
        pressed = goal;
      if (here) pointed = goal;
    }
  }
  ui.Gap(6.0f);
  const std::optional<Goal> about = pointed ? pointed : chosen;
  const std::string line = !about                        ? Tr("Your own mix, from Advanced.")
                           : Offers(*about, figure.name) ? Tr(WordsOf(*about).line)
                                                         : WhyNotOffered(*about, figure.name);
  const ImRect note = ui.Row(18.0f);
  ui.Letters().DrawElided(ui.Canvas(), Type::kNote, {note.Min.x, note.GetCenter().y}, note.GetWidth(),
                          ui.Ink().second_ink, line);
  if (pressed) session.ChangeGoal([&](Document& d) { SetGoal(*pressed, d); });
}

}  // namespace gaitsmith::shell
