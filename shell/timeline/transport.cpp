// SPDX-License-Identifier: MIT
// The transport bar.
#include "shell/timeline/transport.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

struct Speed {
  double value;
  std::string_view label;
};
constexpr std::array<Speed, 4> kSpeeds = {{{1.0, "1×"}, {2.0, "2×"}, {0.25, "¼×"}, {0.5, "½×"}}};

void DrawStrip(Ui& ui, Session& session, const ImRect& rect) {
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
    const float share = std::clamp((ImGui::GetIO().MousePos.x - rect.Min.x) / rect.GetWidth(), 0.0f, 1.0f);
    player.SeekFrame(static_cast<double>(share) * duration);
  }
  if (touch.steps != 0) player.Step(touch.steps);
  if (touch.wanted) {
    player.Play(false);
    player.SeekFrame(*touch.wanted);
  }

  const Palette& p = ui.Ink();
  ImDrawList* list = ui.Canvas();
  const float top = rect.GetCenter().y - 11.0f;
  const float frames = static_cast<float>(std::max(1, player.Shown().Frames() - 1));
  const auto x_of = [&](int frame) {
    return rect.Min.x + std::min(1.0f, static_cast<float>(frame) / frames) * rect.GetWidth();
  };
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
  const float x =
      ui.Look().Snap(rect.Min.x + static_cast<float>(player.TimeS() / duration) * rect.GetWidth());
  list->AddRectFilled({x - 1.0f, top - 4.0f}, {x + 1.0f, top + 20.0f}, p.ink, 1.0f);
  if (touch.hovered || touch.held) list->AddCircleFilled({x, top + 14.0f}, 5.0f, p.ink);
  ui.DrawFocus(touch, rect, 4.0f);
}

}  // namespace

void DrawTransport(Ui& ui, Session& session, const ImRect& rect) {
  const PartScope part = ui.Part("transport", "group", Tr("Playback"));
  const Palette& p = ui.Ink();
  const Fonts& letters = ui.Letters();
  Playback& player = session.Player();
  ui.HorizontalLine(rect.Min.x, rect.Max.x, rect.Min.y);

  const float y = rect.GetCenter().y;
  const float half = ui.Look().touch ? 22.0f : 14.5f;
  float x = rect.Min.x + 14.0f;
  const auto box = [&](float width) {
    const ImRect area({x, y - half}, {x + width, y + half});
    x += width;
    return area;
  };
  const bool playing = player.Playing();
  if (ui.IconButton("transport/play", box(44.0f), playing ? Icon::kPause : Icon::kPlay,
                    Tr(playing ? "Pause" : "Play"), ButtonLook::kOutlined)) {
    player.Play(!playing);
  }
  x += 6.0f;
  if (ui.IconButton("transport/step", box(ui.Look().touch ? 44.0f : 36.0f), Icon::kStepForward,
                    Tr("One step forward")))
    player.Step(1);
  x += 10.0f;

  // The longest time sets the width, so that the layout does not change during playback.
  const std::string total = Fixed(player.DurationS(), 2);
  const float time_width = letters.Width(Type::kBody, total + " s");
  letters.Draw(ui.Canvas(), Type::kBody, {x + time_width, y}, p.second_ink, Fixed(player.TimeS(), 2) + " s",
               Align::kRight);
  x += time_width + 10.0f;

  const float speed_width = 44.0f;
  const ImRect speed_box({rect.Max.x - 14.0f - speed_width, y - half}, {rect.Max.x - 14.0f, y + half});
  const std::string end =
      Fixed(player.DurationS(),
            std::abs(player.DurationS() - std::round(player.DurationS())) < 0.005 ? 0 : 1) +
      " s";
  const float end_x = speed_box.Min.x - 10.0f;
  letters.Draw(ui.Canvas(), Type::kBody, {end_x, y}, p.second_ink, end, Align::kRight);
  const float strip_end = end_x - letters.Width(Type::kBody, end) - 10.0f;
  DrawStrip(ui, session, {{x, y - half}, {strip_end, y + half}});

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
