// SPDX-License-Identifier: MIT
// Draws a motion at one moment, from back to front: ground, shadow, past poses, trail, figure, forces.
#pragma once

#include <imgui.h>

#include <vector>

#include "shell/session/session.h"
#include "shell/stage/camera.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// The part of the world that the camera shows.
struct CameraSettings {
  float zoom = 1.0f;
  double pan_m = 0.0;  // offset of the camera from the figure
};

struct Scene {
  Ui& ui;
  const Session& session;
  const Playback& player;  // the shown motion, or the one compared with it
  ImDrawList* list;
  ImRect rect;
  Camera camera;
  bool rods_only = false;  // draws what is simulated, without a body
};

/// The standing figure takes half of the stage's height, if its width allows. The camera follows smoothly. It
/// backs off for high jumps until the figure would take a third, then looks up.
/// @param rect that the figure must stay in. @param ground_y of the ground line on the canvas [points]
[[nodiscard]] Camera AimCamera(const Playback&, const Environment&, const CameraSettings&, const ImRect& rect,
                               float ground_y);

/// @return the canvas positions of the figure's endpoints
std::vector<ImVec2> DrawScene(const Scene&);

}  // namespace gaitsmith::shell
