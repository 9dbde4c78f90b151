// SPDX-License-Identifier: MIT
#include "shell/panels/keyframes/stance_bars.h"

#include <algorithm>
#include <cmath>

#include "shell/words/language.h"
#include "shell/words/plan_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr float kKeyRow = 28.0f, kRow = 24.0f, kTouchRow = 34.0f, kNames = 26.0f;

std::string SecondsWords(int steps) { return Fixed(static_cast<float>(steps) * kStep, 2) + " s"; }

/// The area of all bars, with time to the right.
struct Field {
  ImRect rect;
  int steps;
  float row;  // height of an endpoint's

  [[nodiscard]] float X(int step) const {
    return rect.Min.x + static_cast<float>(step) / static_cast<float>(steps) * rect.GetWidth();
  }
  [[nodiscard]] int StepAt(float x) const {
    return std::clamp(
        static_cast<int>(std::lround((x - rect.Min.x) / rect.GetWidth() * static_cast<float>(steps))), 0,
        steps);
  }
  [[nodiscard]] float Top(int endpoint) const {
    return rect.Min.y + kKeyRow + row * static_cast<float>(endpoint);
  }
};

void DrawKeyframes(Ui& ui, Session& session, const Field& field, StanceBarsState& state) {
  const auto keyframes = session.Keyframes().Shown().keyframes;  // a copy, since edits replace it
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    const int index = static_cast<int>(i);
    const ImVec2 at(field.X(keyframes[i].step), field.rect.Min.y + 0.5f * kKeyRow);
    const float half = ui.Look().touch ? 16.0f : 10.0f;
    const ImRect rect({at.x - half, at.y - 0.5f * kKeyRow}, {at.x + half, at.y + 0.5f * kKeyRow});
    const Touch touch =
        ui.Area("keyframes/key/" + std::to_string(i), rect, Grab::kArrows,
                {.label = Tr("Keyframe {1} of {2}", index + 1, static_cast<int>(keyframes.size())),
                 .role = "slider",
                 .value = SecondsWords(keyframes[i].step),
                 .state = {.selected = session.Keyframes().Chosen() == index},
                 .range = WidgetRange{kSecondsPerStep, field.steps * kSecondsPerStep, kSecondsPerStep,
                                      keyframes[i].step * kSecondsPerStep}});
    if (touch.began || touch.pressed || touch.steps != 0) {
      session.Keyframes().Choose(index);
      state.stance = -1;
    }
    int wanted = keyframes[i].step + touch.steps;
    if (touch.held && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 3.0f))
      wanted = field.StepAt(ImGui::GetIO().MousePos.x);
    if (touch.wanted) wanted = static_cast<int>(std::lround(*touch.wanted / kSecondsPerStep));
    if (wanted != keyframes[i].step) session.Keyframes().MoveKeyframe(index, wanted);
    const bool chosen = session.Keyframes().Chosen() == index && state.stance < 0;
    DrawDiamond(ui, at, chosen ? ui.Ink().accent : ui.Ink().panel,
                chosen || touch.hovered ? ui.Ink().ink : ui.Ink().second_ink);
    ui.DrawFocus(touch, rect, 4.0f);
  }
}

void DrawBar(Ui& ui, Session& session, const Field& field, std::size_t index, StanceBarsState& state) {
  const Stance stance = session.Keyframes().Shown().stances[index];
  const int number = static_cast<int>(index);
  const float top = field.Top(stance.endpoint);
  const ImRect bar({field.X(stance.first_step), top + 4.0f},
                   {field.X(stance.last_step), top + field.row - 4.0f});
  const bool chosen = state.stance == number;
  const ImU32 colour = ui.Look().Rule(stance.endpoint);
  for (const bool last : {false, true}) {
    const float x = last ? bar.Max.x : bar.Min.x, middle = bar.GetCenter().x;
    const float reach = ui.Look().touch ? 14.0f : 7.0f;
    // Each end has its half of the bar, and a little outside it.
    const ImRect grip = last ? ImRect({std::max(middle, x - 24.0f), top}, {x + reach, top + field.row})
                             : ImRect({x - reach, top}, {std::min(middle, x + 24.0f), top + field.row});
    const int at = last ? stance.last_step : stance.first_step;
    const Touch touch = ui.Area(
        "keyframes/stance/" + std::to_string(index) + (last ? "/until" : "/from"), grip, Grab::kArrows,
        {.label = last ? Tr("{1} stands until", PointWords(stance.endpoint))
                       : Tr("{1} stands from", PointWords(stance.endpoint)),
         .role = "slider",
         .value = SecondsWords(at),
         .range = WidgetRange{0.0, field.steps * kSecondsPerStep, kSecondsPerStep, at * kSecondsPerStep}});
    if (touch.hovered || touch.held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (touch.began || touch.pressed || touch.steps != 0) state.stance = number;
    int wanted = at + touch.steps;
    if (touch.held && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 3.0f))
      wanted = field.StepAt(ImGui::GetIO().MousePos.x);
    if (touch.wanted) wanted = static_cast<int>(std::lround(*touch.wanted / kSecondsPerStep));
    if (wanted != at) session.Keyframes().MoveStance(number, last, wanted);
    ui.DrawFocus(touch, grip, 4.0f);
  }
  ui.Canvas()->AddRectFilled(bar.Min, bar.Max, chosen ? colour : Fade(colour, 0.7f), 5.0f);
  if (chosen) ui.Canvas()->AddRect(bar.Min, bar.Max, ui.Ink().ink, 5.0f, 0, 1.5f);
}

}  // namespace

void DrawDiamond(const Ui& ui, ImVec2 at, ImU32 fill, ImU32 edge) {
  constexpr float kHalf = 7.0f;
  const ImVec2 corners[] = {
      {at.x, at.y - kHalf}, {at.x + kHalf, at.y}, {at.x, at.y + kHalf}, {at.x - kHalf, at.y}};
  ui.Canvas()->AddConvexPolyFilled(corners, 4, fill);
  ui.Canvas()->AddPolyline(corners, 4, edge, ImDrawFlags_Closed, 1.2f);
}

void DrawStanceBars(Ui& ui, Session& session, StanceBarsState& state) {
  const int endpoints = session.Player().Shown().Bones().endpoints;
  const float height = ui.Look().touch ? kTouchRow : kRow;
  const ImRect row = ui.Row(kKeyRow + height * static_cast<float>(endpoints) + 26.0f);
  ui.Frame(row, ui.Ink().paper, ui.Ink().line, 9.0f);
  const Field field{{{row.Min.x + kNames, row.Min.y + 4.0f}, {row.Max.x - 14.0f, row.Max.y - 22.0f}},
                    session.Keyframes().Shown().steps,
                    height};
  for (int k = 0; k < endpoints; ++k) {
    const float y = field.Top(k) + 0.5f * height;
    ui.Letters().Draw(ui.Canvas(), Type::kSmall, {row.Min.x + 10.0f, y}, ui.Ink().second_ink,
                      std::to_string(k + 1));
    ui.Canvas()->AddLine({field.rect.Min.x, y}, {field.rect.Max.x, y}, ui.Ink().line, 1.0f);
  }
  const double seconds = field.steps * static_cast<double>(kStep);
  for (int tick = 0; tick <= 4; ++tick) {
    const float x = field.X(field.steps * tick / 4);
    ui.Letters().Draw(ui.Canvas(), Type::kSmall, {x, row.Max.y - 11.0f}, ui.Ink().second_ink,
                      Fixed(seconds * tick / 4, 2) + (tick == 4 ? " s" : ""),
                      tick == 0   ? Align::kLeft
                      : tick == 4 ? Align::kRight
                                  : Align::kCentre);
  }
  for (std::size_t i = 0; i < session.Keyframes().Shown().stances.size(); ++i)
    DrawBar(ui, session, field, i, state);
  DrawKeyframes(ui, session, field, state);
  const float now = field.X(std::min(session.Player().Frame(), field.steps));
  ui.Canvas()->AddLine({now, field.rect.Min.y}, {now, field.rect.Max.y}, ui.Ink().ink, 1.5f);
}

}  // namespace gaitsmith::shell
