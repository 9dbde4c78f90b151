// SPDX-License-Identifier: MIT
#include "shell/panels/search/front_panel.h"

#include <algorithm>
#include <string>

#include "shell/results/front_map.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr float kHigh = 150.0f;   // of the picture
constexpr float kPoint = 3.5f;    // radius of a point
constexpr float kReach = 7.0f;    // half the side of what a pointer hits
constexpr float kPose = 64.0f;    // edge of the pose
constexpr float kLabels = 18.0f;  // below the picture

}  // namespace

void DrawFront(Ui& ui, Session& session, FrontState& state) {
  const FrontMap& front = *session.Search().Front();
  const std::size_t last = front.Count() - 1;
  state.pointed = std::min(state.pointed, last);
  const Palette& p = ui.Ink();
  ui.Paragraph(front.Title(), Type::kNote);
  ui.Paragraph(
      Tr("The best motion for every price: nothing that was found scores more for less. Click to view."),
      Type::kNote);
  ui.Gap(4.0f);
  const ImRect all = ui.Row(kHigh + kLabels);
  const ImRect picture({all.Min.x + kReach, all.Min.y + kReach},
                       {all.Max.x - kReach, all.Min.y + kHigh - kReach});
  ImDrawList* canvas = ui.Canvas();
  canvas->AddRectFilled(all.Min, {all.Max.x, all.Min.y + kHigh}, Mix(p.panel, p.soft, 0.7f), 3.0f);
  const auto share = [](float value, float low, float high) {
    return high > low ? (value - low) / (high - low) : 0.5f;
  };
  const auto at = [&](std::size_t i) {
    const float right = share(front.Cost(i), front.Cost(0), front.Cost(last));
    const float up = share(front.Score(i), front.Score(0), front.Score(last));
    return ImVec2(picture.Min.x + right * picture.GetWidth(), picture.Max.y - up * picture.GetHeight());
  };
  for (std::size_t i = 0; i < last; ++i) {  // a step: the corner between two motions is what nothing reaches
    const ImVec2 from = at(i), to = at(i + 1);
    canvas->AddLine(from, {to.x, from.y}, p.line, 1.0f);
    canvas->AddLine({to.x, from.y}, to, p.line, 1.0f);
  }
  std::optional<std::size_t> pressed;
  {
    const PartScope part = ui.Part("front/map", "listbox", Tr("Score against cost"));
    for (std::size_t i = 0; i <= last; ++i) {
      const ImVec2 middle = at(i);
      const ImRect area({middle.x - kReach, middle.y - kReach}, {middle.x + kReach, middle.y + kReach});
      const Touch touch = ui.Area("front/" + std::to_string(i), area, Grab::kPress,
                                  {.label = Tr("{1}: {2}", front.CostName(), Fixed(front.Cost(i), 2)),
                                   .role = "option",
                                   .value = Tr("score {1}", Fixed(front.Score(i), 2))});
      if (touch.hovered || touch.focused) state.pointed = i;
      if (touch.pressed) pressed = i;
      const bool shown = state.pointed == i;
      canvas->AddCircleFilled(middle, shown ? 1.5f * kPoint : kPoint, shown ? p.accent : p.ink);
      ui.DrawFocus(touch, area, kReach);
    }
  }
  const ImRect corner({all.Max.x - kPose - 4.0f, all.Min.y + kHigh - kPose - 4.0f},
                      {all.Max.x - 4.0f, all.Min.y + kHigh - 4.0f});
  if (last > 1 && ImGui::IsRectVisible(corner.Min, corner.Max)) {
    const auto motion = [&] { return front.MotionAt(state.pointed); };
    if (const MotionStrip* pose = state.poses.Of(front.Name(state.pointed), motion))
      DrawMotionPose(ui, *pose, corner, p.soft);
  }
  ui.Letters().Draw(
      canvas, Type::kSmall, {all.Min.x, all.Max.y - 0.5f * kLabels}, p.second_ink,
      Tr("{1}, {2} to {3} →", front.CostName(), Fixed(front.Cost(0), 2), Fixed(front.Cost(last), 2)));
  ui.Paragraph(Tr("Score upwards, {1} to {2}. Pointed at: {3} for {4}.", Fixed(front.Score(0), 2),
                  Fixed(front.Score(last), 2), Fixed(front.Score(state.pointed), 2),
                  Fixed(front.Cost(state.pointed), 2)),
               Type::kNote);
  ui.Gap(6.0f);
  if (pressed) session.ShowElite(front.MotionAt(*pressed));
}

}  // namespace gaitsmith::shell
