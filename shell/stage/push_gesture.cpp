// SPDX-License-Identifier: MIT
#include "shell/stage/push_gesture.h"

#include <cmath>

#include "shell/stage/figure_drawing.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {
namespace {

// Change of the centre of mass's velocity per length of the arrow [1/s].
constexpr float kSpeedPerMetre = 3.0f;

// In the viewer the whole figure can be pulled, not only its joints [points].
constexpr float kWholeFigure = 90.0f;

struct Impulse {
  float x_ns, y_ns;
  [[nodiscard]] float Size() const { return std::hypot(x_ns, y_ns); }
};

/// The impulse's components along the ground and away from it [N s].
Impulse ImpulseOf(ImVec2 from, ImVec2 to, const Camera& camera, float mass_kg) {
  const float x = (to.x - from.x) / camera.scale;
  const float y = (to.y - from.y) / camera.scale;
  const float unit = kSpeedPerMetre * mass_kg;
  return {unit * (x * camera.cosine - y * camera.sine), unit * (-x * camera.sine - y * camera.cosine)};
}

int Nearest(std::span<const ImVec2> endpoints, ImVec2 pointer, float reach) {
  int nearest = PushGesture::kNone;
  for (std::size_t k = 0; k < endpoints.size(); ++k) {
    const float distance = std::hypot(endpoints[k].x - pointer.x, endpoints[k].y - pointer.y);
    if (distance >= reach) continue;
    reach = distance;
    nearest = static_cast<int>(k);
  }
  return nearest;
}

}  // namespace

bool PushByHand(Ui& ui, Session& session, PushGesture& gesture, const Touch& stage, const Camera& camera,
                std::span<const ImVec2> endpoints) {
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  const float slack = ui.Look().touch ? 30.0f : 18.0f;
  const float reach = session.Viewing() ? kWholeFigure : slack;
  if (stage.began) {
    gesture = {.endpoint = Nearest(endpoints, pointer, reach), .was_playing = session.Player().Playing()};
  }
  if (gesture.endpoint == PushGesture::kNone) {
    // A ring marks the endpoint that can be dragged.
    const int near = stage.hovered && !stage.held ? Nearest(endpoints, pointer, reach) : PushGesture::kNone;
    if (near != PushGesture::kNone && !ui.Look().touch)
      ui.Canvas()->AddCircle(endpoints[static_cast<std::size_t>(near)], 11.0f, ui.Ink().accent, 0, 2.0f);
    return false;
  }
  const ImVec2 from = endpoints[static_cast<std::size_t>(gesture.endpoint)];
  const Impulse impulse = ImpulseOf(from, pointer, camera, session.Player().Shown().Bones().mass_kg);
  if (stage.held) {
    // Measured from where the pointer went down, because the figure may move under a pointer that rests.
    const ImVec2 down = ImGui::GetIO().MouseClickedPos[0];
    if (!gesture.drawn && std::hypot(pointer.x - down.x, pointer.y - down.y) > slack) {
      gesture.drawn = true;
      session.Player().Play(false);
    }
    if (gesture.drawn) {
      DrawArrow(ui.Canvas(), from, pointer, ui.Ink().accent, Fade(ui.Ink().paper, 0.85f));
      ui.Letters().Draw(ui.Canvas(), Type::kStrong, {pointer.x, pointer.y - 18.0f}, ui.Ink().accent,
                        Fixed(impulse.Size(), 1) + " N s", Align::kCentre);
    }
    return true;
  }
  const bool drawn = gesture.drawn;
  if (drawn) {
    session.World().Push(gesture.endpoint, impulse.x_ns, impulse.y_ns);
    session.Player().Play(gesture.was_playing);
  }
  gesture = {};
  return drawn;
}

}  // namespace gaitsmith::shell
