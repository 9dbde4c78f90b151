// SPDX-License-Identifier: MIT
// A motion at one moment on the canvas, back to front: ground, past poses, trail, figure, forces.
#pragma once

#include <imgui.h>

#include <vector>

#include "shell/session/session.h"
#include "shell/stage/camera.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// The part of the world that the camera shows.
struct Gaze {
  float zoom = 1.0f;
  double pan_m = 0.0;  // offset of the camera from the figure
};

struct Scene {
  Ui& ui;
  const Session& session;
  const Playback& player;  // the shown motion, or the one beside it
  ImDrawList* list;
  ImRect rect;
  Camera camera;
};

/// Keeps the figure's size on the stage constant. The camera follows the figure with a small delay.
/// @param rect in which the figure stays. @param ground_y on the canvas
[[nodiscard]] Camera AimCamera(const Playback&, const Environment&, const Gaze&, const ImRect& rect,
                               float ground_y);

/// @return the canvas positions of the figure's endpoints
std::vector<ImVec2> DrawScene(const Scene&);

}  // namespace gaitsmith::shell
