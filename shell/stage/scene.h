// SPDX-License-Identifier: MIT
// Draws a motion at one moment, from back to front: ground, shadow, past poses, trail, figure, forces.
#pragma once

#include <imgui.h>

#include <vector>

#include "shell/session/session.h"
#include "shell/stage/camera.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct Scene {
  Ui& ui;
  const Session& session;
  const Playback& player;  // the shown motion, or the one compared with it
  ImDrawList* list;
  ImRect rect;
  Camera camera;
  bool rods_only = false;    // draws what is simulated, without a body
  float texts_until = 1e6f;  // texts on the ground end above this height of the canvas: buttons are there
};

/// How far a body is drawn from its rods, because it stands on its soles [points].
[[nodiscard]] ImVec2 RaisedBySoles(const Scene&, const Playback&);

/// @return the canvas positions of the figure's endpoints
std::vector<ImVec2> DrawScene(const Scene&);

}  // namespace gaitsmith::shell
