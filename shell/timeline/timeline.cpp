// SPDX-License-Identifier: MIT
// Clips, their borders and the ruler. Buttons for the selected clip are in timeline_tools.cpp.
#include "shell/timeline/timeline.h"

#include <algorithm>
#include <cmath>

#include "core/document/timeline_edit.h"
#include "shell/timeline/found_drop.h"
#include "shell/timeline/time_ruler.h"
#include "shell/timeline/timeline_tools.h"
#include "shell/timeline/transition_strip.h"
#include "shell/widgets/plot.h"
#include "shell/words/controller_words.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

struct Band {
  ImRect rect;  // area of all clips
  TimeRuler ruler;
  float XOf(int step) const { return ruler.XOf(step * static_cast<double>(kStep)); }
  int StepAt(float x) const {
    return static_cast<int>(std::lround(ruler.TimeAt(x) / static_cast<double>(kStep)));
  }
  float StepsPerPixel() const { return static_cast<float>(StepAt(rect.Max.x)) / rect.GetWidth(); }
};

constexpr float kBandHeight = 48.0f;
constexpr float kSnapPixels = 5.0f;

std::string SecondsWords(int steps) { return Fixed(static_cast<float>(steps) * kStep, 2) + " s"; }

std::string NameOf(const Document& d, int controller) {
  const Controller& c = d.controllers[static_cast<std::size_t>(controller)];
  return c.name.empty() ? Tr("Controller {1}", std::to_string(controller + 1)) : TrTitle(c.name);
}

/// The index to which a dragged clip would move.
int PlaceAt(const Document& d, const Band& band, std::size_t dragged, float x) {
  int place = 0;
  for (std::size_t i = 0; i < d.timeline.size(); ++i) {
    const float middle = 0.5f * (band.XOf(d.timeline[i].start_step) + band.XOf(EndOf(d, i)));
    if (i != dragged && middle < x) ++place;
  }
  return place;
}

/// Marks the target index with a bar between clips.
void DrawPlace(const Ui& ui, const Document& d, const Band& band, std::size_t dragged, int place) {
  auto before = static_cast<std::size_t>(place);
  if (before >= dragged) ++before;  // the dragged clip leaves its old place
  const float x =
      before < d.timeline.size() ? band.XOf(d.timeline[before].start_step) - 2.0f : band.rect.Max.x;
  ui.Canvas()->AddRectFilled({x - 2.0f, band.rect.Min.y - 5.0f}, {x + 2.0f, band.rect.Max.y + 5.0f},
                             ui.Ink().accent, 2.0f);
}

void DragClip(const Ui& ui, Session& session, const Band& band, std::size_t index, const Touch& touch) {
  if (session.Doc().timeline.size() < 2) return;
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  const bool dragged = ImGui::IsMouseDragPastThreshold(ImGuiMouseButton_Left, 8.0f);
  const bool let_go = g.ActiveIdPreviousFrame == touch.id && ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
                      g.IO.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] > 64.0f;
  if (!(touch.held && dragged) && !let_go) return;
  const int place = PlaceAt(session.Doc(), band, index, g.IO.MousePos.x);
  ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  if (let_go) return session.Timeline().ReorderClip(place);
  if (place != static_cast<int>(index)) DrawPlace(ui, session.Doc(), band, index, place);
}

void DrawClip(Ui& ui, Session& session, const Band& band, std::size_t index) {
  const Document& d = session.Doc();
  const Clip& clip = d.timeline[index];
  const Controller& controller = d.controllers[static_cast<std::size_t>(clip.controller)];
  const bool selected = session.Timeline().Selected() == static_cast<int>(index);
  constexpr float kGap = 4.0f;  // between clips
  const ImRect rect({band.XOf(clip.start_step), band.rect.Min.y},
                    {band.XOf(EndOf(d, index)) - kGap, band.rect.Max.y});
  const std::string name = NameOf(d, clip.controller);
  const std::string length = SecondsWords(EndOf(d, index) - clip.start_step);
  const std::string words = ControllerWords(controller.kind, controller.senses, controller.rules);
  const int colour_of = clip.controller;
  ImGui::PushItemFlag(ImGuiItemFlags_AllowOverlap, true);  // borders are small and drawn later
  const Touch touch = ui.Area("timeline/clip/" + std::to_string(index), rect, Grab::kDrag,
                              {.label = Tr("Clip {1} of {2}: {3}", std::to_string(index + 1),
                                           std::to_string(d.timeline.size()), name),
                               .role = "option",
                               .value = Tr("{1} from {2}", length, SecondsWords(clip.start_step)),
                               .state = {.selected = selected}});
  ImGui::PopItemFlag();
  if (touch.pressed) session.Timeline().Select(static_cast<int>(index));

  const Palette& p = ui.Ink();
  const ImU32 colour = ui.Look().Rule(colour_of);
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
                            length + " · " + words);
  }
  ui.DrawFocus(touch, rect, 8.0f);
  DragClip(ui, session, band, index, touch);
}

/// Snaps a step to the shown moment or a multiple of half a second, if one is near.
int Snapped(const Session& session, const Band& band, int step) {
  const float steps_per_pixel = band.StepsPerPixel();
  const auto near = [&](int target) {
    return std::abs(static_cast<float>(target - step)) < kSnapPixels * steps_per_pixel;
  };
  if (near(session.Player().Frame())) return session.Player().Frame();
  const int half_second = static_cast<int>(std::lround(static_cast<float>(step) / 50.0f)) * 50;
  return near(half_second) ? half_second : step;
}

/// Handles a border's drag and keys. @return the requested step, or `at`
int DragBorder(Ui& ui, const Session& session, const Band& band, const std::string& id, Widget description,
               int at) {
  constexpr auto kStepS = static_cast<double>(kStep);
  const float x = ui.Look().Snap(band.XOf(at) - 2.0f);
  const float half = ui.Look().touch ? 16.0f : 7.0f;
  const ImRect rect({x - half, band.rect.Min.y - 4.0f}, {x + half, band.rect.Max.y + 4.0f});
  description.role = "slider";
  description.range = WidgetRange{0.0, kMaxSteps * kStepS, kStepS, at * kStepS};
  const Touch touch = ui.Area(id, rect, Grab::kArrows, std::move(description));
  if (touch.hovered || touch.held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  int wanted = at + touch.steps;
  if (touch.held && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2.0f))
    wanted = Snapped(session, band, band.StepAt(ImGui::GetIO().MousePos.x + 2.0f));
  if (touch.wanted) wanted = static_cast<int>(std::lround(*touch.wanted / kStepS));

  const ImU32 ink = touch.hovered || touch.held ? ui.Ink().ink : ui.Ink().second_ink;
  const float y = band.rect.GetCenter().y;
  ui.Canvas()->AddRectFilled({x - 1.5f, y - 12.0f}, {x + 1.5f, y + 12.0f}, ink, 1.5f);
  if (touch.held) DrawBubble(ui, x, band.rect, band.rect.Min.y, SecondsWords(at));
  ui.DrawFocus(touch, rect, 4.0f);
  return wanted;
}

void DrawSwitchPoint(Ui& ui, Session& session, const Band& band, std::size_t index) {
  const Document& d = session.Doc();
  const int start = d.timeline[index].start_step;
  const int wanted =
      DragBorder(ui, session, band, "timeline/switch/" + std::to_string(index),
                 {.label = Tr("Border {1} of {2}: clip {3} takes over", std::to_string(index),
                              std::to_string(d.timeline.size() - 1), std::to_string(index + 1)),
                  .value = SecondsWords(start)},
                 start);
  if (wanted != start) session.Timeline().MoveClip(static_cast<int>(index), wanted);
}

/// The end of the motion, which sets the last clip's length. The band always shows the whole motion, so the
/// end cannot follow the pointer. A drag changes the length by the distance dragged.
void DrawEnd(Ui& ui, Session& session, const Band& band) {
  const Document& d = session.Doc();
  const std::size_t last = d.timeline.size() - 1;
  const int end = d.duration_steps;
  const int length = end - d.timeline[last].start_step;
  const bool was_dragged = ImGui::GetIO().MouseDelta.x != 0.0f;
  int wanted = DragBorder(ui, session, band, "timeline/end",
                          {.label = Tr("End of the motion"), .value = SecondsWords(end)}, end);
  if (wanted == end) return;
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    if (!was_dragged) return;
    // Carries fractions of a step over to the next frame.
    ImGuiStorage* storage = ImGui::GetStateStorage();
    const ImGuiID key = ImGui::GetID("timeline/end/pull");
    const float rest = ImGui::IsMouseClicked(ImGuiMouseButton_Left) ? 0.0f : storage->GetFloat(key);
    const float pull = rest + ImGui::GetIO().MouseDelta.x * band.StepsPerPixel();
    const int steps = static_cast<int>(pull);
    storage->SetFloat(key, pull - static_cast<float>(steps));
    wanted = end + steps;
  }
  session.Timeline().SetClipLength(static_cast<int>(last), length + wanted - end);
}

void DrawRuler(Ui& ui, const Session& session, const Band& band) {
  const float y = band.rect.Max.y + TransitionStripHeight(session) + 12.0f;
  for (const double tick : NiceTicks(0.0, band.ruler.seconds)) {
    const std::string text = Fixed(tick, tick == std::floor(tick) ? 0 : 1) + " s";
    const float half = 0.5f * ui.Letters().Width(Type::kSmall, text);
    const float x = std::clamp(band.ruler.XOf(tick), band.rect.Min.x + half, band.rect.Max.x - half);
    ui.Letters().Draw(ui.Canvas(), Type::kSmall, {x, y}, ui.Ink().second_ink, text, Align::kCentre);
  }
  // The playhead is faint over the clips' names and solid at their lower edge.
  const float x = ui.Look().Snap(band.ruler.XOf(session.Player().TimeS()));
  const float bottom = band.rect.Max.y;
  ui.Canvas()->AddRectFilled({x - 0.5f, band.rect.Min.y + 1.0f}, {x + 0.5f, bottom - 1.0f},
                             Fade(ui.Ink().ink, 0.22f));
  ui.Canvas()->AddTriangleFilled({x, bottom - 5.0f}, {x + 4.5f, bottom + 3.0f}, {x - 4.5f, bottom + 3.0f},
                                 ui.Ink().ink);
}

// A hint about available actions or, for a clip that takes over, the verdict on it.
std::string HintOf(const Session& session) {
  const std::size_t clips = session.Doc().timeline.size();
  if (clips == 0) return Tr("empty until a search finds a controller");
  if (clips == 1) return Tr("Drag a result here to chain motions");
  const auto share = session.Timeline().Transitions().ShareAtStart();
  if (!share) return Tr("drag clips and the borders between them");
  return Tr("clip {1} takes over: {2}, {3} % of its usual score",
            std::to_string(session.Timeline().Selected() + 1), VerdictWords(*share), PercentOf(*share));
}

}  // namespace

void DrawBubble(const Ui& ui, float x, const ImRect& within, float bottom, const std::string& words) {
  const float width = 0.5f * ui.Letters().Width(Type::kSmall, words) + 6.0f;
  const ImVec2 centre(std::clamp(x, within.Min.x + width, within.Max.x - width), bottom - 9.0f);
  ui.Frame({{centre.x - width, centre.y - 9.0f}, {centre.x + width, centre.y + 9.0f}}, ui.Ink().ink,
           ui.Ink().ink);
  ui.Letters().Draw(ui.Canvas(), Type::kSmall, centre, ui.Ink().panel, words, Align::kCentre);
}

void DrawTimeline(Ui& ui, Session& session, const ImRect& rect) {
  const PartScope part = ui.Part("timeline", "region", Tr("Timeline"));
  const Palette& p = ui.Ink();
  const bool empty = session.Doc().timeline.empty();
  ui.HorizontalLine(rect.Min.x, rect.Max.x, rect.Min.y);

  const float left = rect.Min.x + kPanelPadding;
  const float right = rect.Max.x - kPanelPadding;
  const float half = ui.Look().touch ? 18.0f : 12.0f;
  const float row = rect.Min.y + (ui.Look().touch ? 24.0f : 19.0f);
  const float top = row + (ui.Look().touch ? 24.0f : 16.0f);
  const bool narrow = IsNarrowRuler(rect.GetWidth());
  const TimeRuler ruler = RulerOf(ui, session, rect, narrow);
  const Band band{.rect = {{ruler.left, top}, {ruler.right, top + kBandHeight}}, .ruler = ruler};
  // The heading lies beside the clips where the transport's buttons leave room there.
  const char* heading = Tr("Timeline");
  ui.Letters().Draw(ui.Canvas(), Type::kStrong, {left, narrow ? row : band.rect.GetCenter().y}, p.ink,
                    heading);
  const float hint_x = narrow ? left + ui.Letters().Width(Type::kStrong, heading) + 8.0f : left;
  // Tools are in the heading's row if they fit, else in rows below the ruler.
  const ImRect below({left, band.rect.Max.y + TransitionStripHeight(session) + 24.0f}, {right, rect.Max.y});
  const float tools_x = DrawTimelineTools(ui, session, {{hint_x, row - half}, {right, row + half}}, below);
  const std::string hint = HintOf(session);
  if (tools_x - 10.0f > hint_x + 40.0f) {
    ui.Letters().DrawElided(ui.Canvas(), Type::kBody, {hint_x, row}, tools_x - 10.0f - hint_x, p.second_ink,
                            hint);
  }
  ui.DescribeText(hint, {{hint_x, row - half}, {std::max(hint_x, tools_x - 10.0f), row + half}});

  if (empty) {
    ui.Canvas()->AddRectFilled(band.rect.Min, band.rect.Max, p.soft, 8.0f);
    return TakeFound(ui, session, band.rect);
  }
  // Drawing may remove clips, so read the count again in each iteration.
  {
    const PartScope clips = ui.Part("timeline/clips", "listbox", Tr("Clips"));
    for (std::size_t i = 0; i < session.Doc().timeline.size(); ++i) DrawClip(ui, session, band, i);
  }
  DrawTransitionStrip(ui, session, band.rect);
  DrawRuler(ui, session, band);
  for (std::size_t i = 1; i < session.Doc().timeline.size(); ++i) DrawSwitchPoint(ui, session, band, i);
  DrawEnd(ui, session, band);
  TakeFound(ui, session, band.rect);
}

}  // namespace gaitsmith::shell
