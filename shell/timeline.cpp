// SPDX-License-Identifier: MIT
// Clips, switch points and the ruler under them.
#include "shell/timeline.h"

#include <algorithm>
#include <cmath>

#include "shell/language.h"
#include "shell/plot.h"
#include "shell/wording.h"

namespace gaitsmith::shell {
namespace {

struct Band {
  ImRect rect;  // of all clips
  float steps;
  float XOf(int step) const { return rect.Min.x + static_cast<float>(step) / steps * rect.GetWidth(); }
  int StepAt(float x) const {
    return static_cast<int>(std::lround((x - rect.Min.x) / rect.GetWidth() * steps));
  }
};

void DrawClip(Ui& ui, Session& session, const Band& band, std::size_t index) {
  const Document& d = session.Doc();
  const Clip& clip = d.timeline[index];
  const Controller& controller = d.controllers[static_cast<std::size_t>(clip.controller)];
  const bool selected = session.SelectedClip() == static_cast<int>(index);
  const float gap = index + 1 < d.timeline.size() ? 4.0f : 0.0f;
  const ImRect rect({band.XOf(clip.start_step), band.rect.Min.y},
                    {band.XOf(EndOf(d, index)) - gap, band.rect.Max.y});
  const std::string name =
      controller.name.empty() ? Tr("Controller {1}", clip.controller + 1) : TrTitle(controller.name);
  const Touch touch = ui.Area("timeline/clip/" + std::to_string(index), rect, Grab::kPress,
                              {.label = name,
                               .role = "option",
                               .value = Fixed(static_cast<float>(clip.start_step) * kStep, 2) + " s",
                               .state = {.selected = selected}});
  if (touch.pressed) session.SelectClip(static_cast<int>(index));

  const Palette& p = ui.Ink();
  const ImU32 colour = ui.Look().Rule(clip.controller);
  ImDrawList* list = ui.Canvas();
  const float tint = touch.hovered ? 0.19f : 0.13f;
  ui.Frame(rect, Mix(p.panel, colour, tint), colour, 8.0f);
  if (selected && d.timeline.size() > 1) {
    list->AddRect({rect.Min.x + 0.5f, rect.Min.y + 0.5f}, {rect.Max.x - 0.5f, rect.Max.y - 0.5f}, colour,
                  8.0f, 0, 2.0f);
  }
  const float room = rect.GetWidth() - 18.0f;
  if (room > 12.0f) {
    const ImVec2 at(rect.Min.x + 10.0f, rect.Min.y);
    ui.Letters().DrawElided(list, Type::kStrong, {at.x, at.y + 16.0f}, room, p.ink, name);
    ui.Letters().DrawElided(list, Type::kSmall, {at.x, at.y + 34.0f}, room, p.second_ink,
                            ControllerWords(controller.kind, controller.senses, controller.rules));
  }
  ui.DrawFocus(touch, rect, 8.0f);
}

void DrawSwitchPoint(Ui& ui, Session& session, const Band& band, std::size_t index) {
  const int start = session.Doc().timeline[index].start_step;
  constexpr auto kStepS = static_cast<double>(kStep);
  const float x = ui.Look().Snap(band.XOf(start) - 2.0f);
  const float half = ui.Look().touch ? 16.0f : 7.0f;
  const ImRect rect({x - half, band.rect.Min.y - 4.0f}, {x + half, band.rect.Max.y + 4.0f});
  const Touch touch =
      ui.Area("timeline/switch/" + std::to_string(index), rect, Grab::kArrows,
              {.label = Tr("Switch point before clip {1}", std::to_string(index + 1)),
               .role = "slider",
               .value = Fixed(static_cast<float>(start) * kStep, 2) + " s",
               .range = WidgetRange{0.0, session.Doc().duration_steps * kStepS, kStepS, start * kStepS}});
  if (touch.hovered || touch.held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (touch.held && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2.0f)) {
    session.MoveClip(static_cast<int>(index), band.StepAt(ImGui::GetIO().MousePos.x + 2.0f));
  }
  if (touch.steps != 0) session.MoveClip(static_cast<int>(index), start + touch.steps);
  if (touch.wanted)
    session.MoveClip(static_cast<int>(index), static_cast<int>(std::lround(*touch.wanted / kStepS)));

  const ImU32 ink = touch.hovered || touch.held ? ui.Ink().ink : ui.Ink().second_ink;
  const float y = band.rect.GetCenter().y;
  ui.Canvas()->AddRectFilled({x - 1.5f, y - 12.0f}, {x + 1.5f, y + 12.0f}, ink, 1.5f);
  if (touch.held) {
    ui.Letters().Draw(ui.Canvas(), Type::kSmall, {x, band.rect.Max.y + 12.0f}, ui.Ink().ink,
                      Fixed(static_cast<float>(start) * kStep, 2) + " s", Align::kCentre);
  }
  ui.DrawFocus(touch, rect, 4.0f);
}

void DrawRuler(Ui& ui, const Session& session, const Band& band) {
  const double seconds = static_cast<double>(band.steps) * static_cast<double>(kStep);
  const float y = band.rect.Max.y + 12.0f;
  const auto x_of = [&](double time_s) {
    return band.rect.Min.x + static_cast<float>(time_s / seconds) * band.rect.GetWidth();
  };
  for (const double tick : NiceTicks(0.0, seconds)) {
    const std::string text = Fixed(tick, tick == std::floor(tick) ? 0 : 1) + " s";
    const float half = 0.5f * ui.Letters().Width(Type::kSmall, text);
    const float x = std::clamp(x_of(tick), band.rect.Min.x + half, band.rect.Max.x - half);
    ui.Letters().Draw(ui.Canvas(), Type::kSmall, {x, y}, ui.Ink().second_ink, text, Align::kCentre);
  }
  // The playhead is faint over the clips' names and plain at their lower edge.
  const float x = ui.Look().Snap(x_of(session.player.TimeS()));
  const float bottom = band.rect.Max.y;
  ui.Canvas()->AddRectFilled({x - 0.5f, band.rect.Min.y + 1.0f}, {x + 0.5f, bottom - 1.0f},
                             Fade(ui.Ink().ink, 0.22f));
  ui.Canvas()->AddTriangleFilled({x, bottom - 5.0f}, {x + 4.5f, bottom + 3.0f}, {x - 4.5f, bottom + 3.0f},
                                 ui.Ink().ink);
}

}  // namespace

void DrawTimeline(Ui& ui, Session& session, const ImRect& rect) {
  const PartScope part = ui.Part("timeline", "region", Tr("Timeline"));
  const Palette& p = ui.Ink();
  const bool empty = session.Doc().timeline.empty();
  ui.HorizontalLine(rect.Min.x, rect.Max.x, rect.Min.y);

  const float row_y = rect.Min.y + 19.0f;
  const float left = rect.Min.x + kPanelPadding;
  const float right = rect.Max.x - kPanelPadding;
  const float half = ui.Look().touch ? 18.0f : 12.0f;
  const float row = ui.Look().touch ? rect.Min.y + 24.0f : row_y;
  if (ui.Button("timeline/remove", {{right - 66.0f, row - half}, {right, row + half}}, Tr("Remove"),
                ButtonLook::kPlain, session.Doc().timeline.size() > 1, Tr("Remove the selected clip"))) {
    session.RemoveClip();
  }
  if (ui.Button("timeline/add", {{right - 142.0f, row - half}, {right - 70.0f, row + half}}, Tr("Add clip"),
                ButtonLook::kPlain, !empty)) {
    session.AddClip();
  }
  ui.Letters().Draw(ui.Canvas(), Type::kStrong, {left, row}, p.ink, Tr("Timeline"));
  const float hint_x = left + ui.Letters().Width(Type::kStrong, Tr("Timeline")) + 8.0f;
  const std::string_view hint =
      Tr(empty                               ? "empty until a search finds a controller"
         : session.Doc().timeline.size() > 1 ? "drag a switch point; a search improves the selected clip"
                                             : "add a clip to chain another motion");
  ui.Letters().DrawElided(ui.Canvas(), Type::kBody, {hint_x, row}, right - 152.0f - hint_x, p.second_ink,
                          hint);
  ui.Tell(hint, {{hint_x, row - half}, {std::max(hint_x, right - 152.0f), row + half}});

  const float top = row + (ui.Look().touch ? 24.0f : 16.0f);
  const Band band{.rect = {{left, top}, {right, top + 48.0f}},
                  .steps = static_cast<float>(std::max(1, session.Doc().duration_steps))};
  if (empty) {
    ui.Canvas()->AddRectFilled(band.rect.Min, band.rect.Max, p.soft, 8.0f);
    return;
  }
  // Clips may go away while they are drawn, so the count is looked at anew.
  {
    const PartScope clips = ui.Part("timeline/clips", "listbox", Tr("Clips"));
    for (std::size_t i = 0; i < session.Doc().timeline.size(); ++i) DrawClip(ui, session, band, i);
  }
  DrawRuler(ui, session, band);
  for (std::size_t i = 1; i < session.Doc().timeline.size(); ++i) DrawSwitchPoint(ui, session, band, i);
}

}  // namespace gaitsmith::shell
