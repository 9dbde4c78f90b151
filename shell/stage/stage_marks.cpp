// SPDX-License-Identifier: MIT
#include "shell/stage/stage_marks.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "shell/words/language.h"
#include "shell/words/plan_words.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

constexpr float kMarkRing = 7.0f, kMarkWhisker = 13.0f;
constexpr double kMarkStep = 0.05;  // of the arrow keys [m]

/// A mark on the canvas, and the figure's point at that moment.
struct MarkPlace {
  ImVec2 wanted, reached;
};

/// Where only one coordinate counts, the other one is that of the figure's point.
MarkPlace PlaceOf(const Scene& s, const Keyframe& keyframe, const Mark& mark) {
  const Playback& player = s.session.Comparison().PlannedOrShown();
  const double time_s = keyframe.step * static_cast<double>(kStep);
  Playback::Point at = player.CentreAt(time_s);
  if (mark.endpoint != kCentreOfMass)
    at = player.EndpointsAt(time_s)[static_cast<std::size_t>(mark.endpoint)];
  const ImVec2 raised = RaisedBySoles(s, player);
  const auto on_stage = [&](double x_m, float y_m) {
    const ImVec2 point = s.camera.ToScreen(x_m, y_m);
    return ImVec2(point.x + raised.x, point.y + raised.y);
  };
  return {on_stage(mark.axes == MarkAxes::kUp ? at.x_m : static_cast<double>(mark.x_m),
                   mark.axes == MarkAxes::kAlong ? at.y_m : mark.y_m),
          on_stage(at.x_m, at.y_m)};
}

void DrawMark(const Scene& s, const MarkPlace& place, MarkAxes axes, bool chosen, bool lit) {
  const Palette& p = s.ui.Ink();
  const ImVec2 at = place.wanted;
  const auto whisker = [&](float along, float up) {
    // The ground's axes, which a slope tilts.
    const ImVec2 way(along * s.camera.cosine - up * s.camera.sine,
                     -along * s.camera.sine - up * s.camera.cosine);
    const ImVec2 from(at.x - kMarkWhisker * way.x, at.y - kMarkWhisker * way.y),
        to(at.x + kMarkWhisker * way.x, at.y + kMarkWhisker * way.y);
    s.list->AddLine(from, to, p.paper, 5.0f);
    s.list->AddLine(from, to, p.accent, 2.0f);
  };
  if (std::hypot(at.x - place.reached.x, at.y - place.reached.y) > kMarkRing)
    s.list->AddLine(place.reached, at, Fade(p.accent, 0.6f), 1.5f);
  if (axes != MarkAxes::kUp) whisker(0.0f, 1.0f);
  if (axes != MarkAxes::kAlong) whisker(1.0f, 0.0f);
  const float ring = lit ? kMarkRing + 2.0f : kMarkRing;
  s.list->AddCircleFilled(at, ring + 1.5f, p.paper);
  s.list->AddCircle(at, ring, p.accent, 0, 2.5f);
  if (chosen) s.list->AddCircleFilled(at, ring - 3.0f, p.accent);
}

float Centimetres(double metres, double low) {
  return static_cast<float>(std::clamp(std::round(metres * 100.0) / 100.0, low, 200.0));
}

}  // namespace

bool ShowsKeyframes(const Session& session) {
  return !session.Viewing() && session.Keyframes().Open() &&
         session.Doc().view.panel == static_cast<int>(Panel::kKeyframes);
}

void DrawMarks(Session& session, const Scene& s) {
  const auto keyframes = session.Keyframes().Shown().keyframes;  // a copy, since edits replace it
  for (std::size_t k = 0; k < keyframes.size(); ++k) {
    for (std::size_t m = 0; m < keyframes[k].marks.size(); ++m) {
      const int keyframe = static_cast<int>(k);
      const Mark& mark = keyframes[k].marks[m];
      const MarkPlace place = PlaceOf(s, keyframes[k], mark);
      if (!s.rect.Contains(place.wanted)) continue;
      const float half = s.ui.Look().touch ? 24.0f : kMarkWhisker;
      const ImRect rect({place.wanted.x - half, place.wanted.y - half},
                        {place.wanted.x + half, place.wanted.y + half});
      const bool up = mark.axes == MarkAxes::kUp;
      const double along = static_cast<double>(up ? mark.y_m : mark.x_m);
      const Touch touch =
          s.ui.Area("stage/mark/" + std::to_string(k) + "/" + std::to_string(m), rect, Grab::kArrows,
                    {.label = Tr("Mark of keyframe {1}: {2}", keyframe + 1, PointWords(mark.endpoint)),
                     .role = "slider",
                     .value = Fixed(along, 2) + " m",
                     .range = WidgetRange{up ? 0.0 : -200.0, 200.0, kMarkStep, along}});
      if (touch.began || touch.pressed || touch.steps != 0) session.Keyframes().Choose(keyframe);
      if (touch.began) session.Player().Play(false);  // the camera must not move on
      std::optional<Camera::Place> wanted;
      if (touch.held && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 3.0f)) {
        const ImVec2 raised = RaisedBySoles(s, session.Comparison().PlannedOrShown()),
                     pointer = ImGui::GetIO().MousePos;
        wanted = s.camera.ToMetres({pointer.x - raised.x, pointer.y - raised.y});
      } else if (touch.steps != 0 || touch.wanted) {
        const double to = touch.wanted ? *touch.wanted : along + kMarkStep * touch.steps;
        wanted =
            Camera::Place{up ? static_cast<double>(mark.x_m) : to, up ? static_cast<float>(to) : mark.y_m};
      }
      if (wanted)
        session.Keyframes().MoveMark(keyframe, static_cast<int>(m), Centimetres(wanted->x_m, -200.0),
                                     Centimetres(static_cast<double>(wanted->y_m), 0.0));
      DrawMark(s, place, mark.axes, session.Keyframes().Chosen() == keyframe, touch.hovered || touch.held);
      s.ui.DrawFocus(touch, rect, 6.0f);
    }
  }
}

}  // namespace gaitsmith::shell
