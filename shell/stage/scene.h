// SPDX-License-Identifier: MIT
// A motion at one moment on the canvas, back to front: ground, past poses, trail, figure, forces.
#pragma once

#include <imgui.h>

#include <vector>

#include "shell/session/session.h"
#include "shell/stage/camera.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// Where a person looks.
struct Gaze {
  float zoom = 1.0f;
  double pan_m = 0.0;  // of the camera away from the figure
};

struct Scene {
  Ui& ui;
  const Session& session;
  const Playback& player;  // the shown motion, or the one beside it
  ImDrawList* list;
  ImRect rect;
  Camera camera;
};

/// The figure keeps its size on the stage; where it goes, the camera follows a little later than it.
/// @param rect that the figure keeps in. @param ground_y on the canvas
[[nodiscard]] Camera AimCamera(const Playback&, const Environment&, const Gaze&, const ImRect& rect,
                               float ground_y);

/// @return where the figure's endpoints are on the canvas
std::vector<ImVec2> DrawScene(const Scene&);

}  // namespace gaitsmith::shell
