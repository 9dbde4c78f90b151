// SPDX-License-Identifier: MIT
// The transport bar.
#include "shell/timeline/transport.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "shell/timeline/time_ruler.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

struct Speed {
  double value;
  std::string_view label;
};
constexpr std::array<Speed, 4> kSpeeds = {{{1.0, "1×"}, {2.0, "2×"}, {0.25, "¼×"}, {0.5, "½×"}}};

constexpr float kRulerRow = 26.0f, kTouchRulerRow = 38.0f;
constexpr float kPlayWidth = 44.0f, kSpeedWidth = 44.0f;
constexpr float kGap = 10.0f;

float StepWidth(const Ui& ui) { return ui.Look().touch ? 44.0f : 36.0f; }
float HeightOfRow(const Theme& look) { return look.touch ? kTouchTransportHeight : kTransportHeight; }
std::string LengthText(const Playback& player) {
  const double length = player.DurationS();
  return Fixed(length, std::abs(length - std::round(length)) < 0.005 ? 0 : 1) + " s";
}

/// A bracket over one cycle of the motion, for assistive tools a sentence.
void DrawCycle(Ui& ui, const GaitCycle& cycle, double distance_m, float left, float right, float y) {
  const Palette& p = ui.Ink();
  ImDrawList* list = ui.Canvas();
  list->AddRectFilled({left, y - 2.0f}, {right, y}, p.accent);
  for (const float end : {left, right - 1.5f})
    list->AddRectFilled({end, y - 2.0f}, {end + 1.5f, y + 2.0f}, p.accent);
  const std::string seconds = Fixed(cycle.PeriodS(), 2);
  const std::string words = std::abs(distance_m) < 0.005 ? Tr("Repeats every {1} s", seconds)
                                                         : Tr("Gait of {1} s and {2} m a cycle", seconds,
                                                              Fixed(std::abs(distance_m), 2));
  ui.DescribeText(words, {{left, y - 2.0f}, {right, y + 2.0f}});
}

/// @param y centre of the drawing; the whole area can be pressed
void DrawStrip(Ui& ui, Session& session, const TimeRuler& ruler, const ImRect& rect, float y) {
  Playback& player = session.Player();
  const double duration = std::max(player.DurationS(), 1e-6);
  const Touch touch = ui.Area(
      "transport/scrub", rect, Grab::kArrows,
      {.label = Tr("Time"),
       .role = "slider",
       .value = Fixed(player.TimeS(), 2) + " s",
       .range = WidgetRange{0.0, duration, static_cast<double>(player.Shown().StepS()), player.TimeS()}});
  if (touch.held) {
    if (touch.began) player.Play(false);
    player.SeekFrame(ruler.TimeAt(ImGui::GetIO().MousePos.x));
  }
  if (touch.steps != 0) player.Step(touch.steps);
  if (touch.wanted) {
    player.Play(false);
    player.SeekFrame(*touch.wanted);
  }

  const Palette& p = ui.Ink();
  ImDrawList* list = ui.Canvas();
  const float top = y - 11.0f;
  const auto x_of = [&](int frame) { return ruler.XOf(frame * static_cast<double>(player.Shown().StepS())); };
  for (const RuleRun& run : player.Runs()) {
    const float left = x_of(run.start_frame);
    const float right = x_of(run.end_frame);
    list->AddRectFilled({left, top}, {right, top + 8.0f}, ui.Look().Rule(run.rule),
                        right - left > 5.0f ? 2.0f : 0.0f);
  }
  // A bar below the rules: dark while the figure touches the ground, light in flight.
  list->AddRectFilled({rect.Min.x, top + 12.5f}, {rect.Max.x, top + 15.5f}, p.line, 1.5f);
  for (const Contact& contact : player.Contacts()) {
    list->AddRectFilled({x_of(contact.start_frame), top + 12.5f}, {x_of(contact.end_frame), top + 15.5f},
                        Mix(p.panel, p.second_ink, 0.7f));
  }
  if (const auto& cycle = session.Gait().Cycle())
    DrawCycle(ui, *cycle, session.Gait().DistanceM(), x_of(cycle->first),
              x_of(cycle->first + static_cast<int>(std::lround(cycle->frames))), top - 3.0f);
  const float x = ui.Look().Snap(ruler.XOf(player.TimeS()));
  list->AddRectFilled({x - 1.0f, top - 4.0f}, {x + 1.0f, top + 20.0f}, p.ink, 1.0f);
  if (touch.hovered || touch.held) list->AddCircleFilled({x, top + 14.0f}, 5.0f, p.ink);
  ui.DrawFocus(touch, rect, 4.0f);
}

}  // namespace

float TransportHeight(const Theme& look, float width, bool low) {
  const float ruler = look.touch ? kTouchRulerRow : kRulerRow;
  return HeightOfRow(look) + (IsNarrowRuler(width) && !low ? ruler : 0.0f);
}

TransportLayout LayoutOf(const Ui& ui, const Playback& player, const ImRect& bar) {
  // The longest time sets the width, so that the layout does not change during playback.
  const float time = ui.Letters().Width(Type::kBody, Fixed(player.DurationS(), 2) + " s");
  const float length = ui.Letters().Width(Type::kBody, LengthText(player));
  return {.time_end = bar.Min.x + kPanelPadding + kPlayWidth + 6.0f + StepWidth(ui) + kGap + time,
          .end_start = bar.Max.x - kPanelPadding - kSpeedWidth - kGap - length};
}

void DrawTransport(Ui& ui, Session& session, const ImRect& rect) {
  const PartScope part = ui.Part("transport", "group", Tr("Playback"));
  const Palette& p = ui.Ink();
  const Fonts& letters = ui.Letters();
  Playback& player = session.Player();
  ui.HorizontalLine(rect.Min.x, rect.Max.x, rect.Min.y);

  const float row = HeightOfRow(ui.Look());
  const bool own_row = rect.GetHeight() > row + 1.0f;
  const float y = rect.Max.y - 0.5f * row;
  const float half = ui.Look().touch ? 22.0f : 14.5f;
  float x = rect.Min.x + kPanelPadding;
  const auto box = [&](float width) {
    const ImRect area({x, y - half}, {x + width, y + half});
    x += width;
    return area;
  };
  const bool playing = player.Playing();
  if (ui.IconButton("transport/play", box(kPlayWidth), playing ? Icon::kPause : Icon::kPlay,
                    Tr(playing ? "Pause" : "Play"), ButtonLook::kOutlined)) {
    player.Play(!playing);
  }
  x += 6.0f;
  if (ui.IconButton("transport/step", box(StepWidth(ui)), Icon::kStepForward, Tr("One step forward")))
    player.Step(1);

  const TransportLayout layout = LayoutOf(ui, player, rect);
  letters.Draw(ui.Canvas(), Type::kBody, {layout.time_end, y}, p.second_ink, Fixed(player.TimeS(), 2) + " s",
               Align::kRight);
  letters.Draw(ui.Canvas(), Type::kBody, {layout.end_start, y}, p.second_ink, LengthText(player));
  const TimeRuler ruler = RulerOf(ui, session, rect, own_row);
  const float ruler_bottom = rect.Max.y - row;
  if (own_row) {
    DrawStrip(ui, session, ruler, {{ruler.left, rect.Min.y + 1.0f}, {ruler.right, ruler_bottom}},
              0.5f * (rect.Min.y + ruler_bottom) + 4.0f);
  } else {
    DrawStrip(ui, session, ruler, {{ruler.left, y - half}, {ruler.right, y + half}}, y);
  }

  const ImRect speed_box({rect.Max.x - kPanelPadding - kSpeedWidth, y - half},
                         {rect.Max.x - kPanelPadding, y + half});
  std::size_t speed = 0;
  for (std::size_t i = 0; i < kSpeeds.size(); ++i) {
    if (std::abs(player.speed - kSpeeds[i].value) < 1e-6) speed = i;
  }
  if (ui.Button("transport/speed", speed_box, kSpeeds[speed].label, ButtonLook::kOutlined, true,
                Tr("Speed {1}", kSpeeds[speed].label))) {
    player.speed = kSpeeds[(speed + 1) % kSpeeds.size()].value;
    session.SetView([&](View& view) { view.speed = static_cast<float>(player.speed); });
  }
}

}  // namespace gaitsmith::shell
