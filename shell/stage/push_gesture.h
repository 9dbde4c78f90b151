// SPDX-License-Identifier: MIT
// Pushing the figure by hand: drag an arrow out of a joint or tip and release it. Adds an impulse at the
// shown moment.
#pragma once

#include <span>

#include "shell/session/session.h"
#include "shell/stage/camera.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct PushGesture {
  int endpoint = kNone;  // the endpoint at which the arrow starts
  bool drawn = false;    // the pointer has moved far enough to draw an arrow
  bool was_playing = false;

  static constexpr int kNone = -1;
};

/// Handles the stage's input and draws the arrow. Pauses playback during the drag.
/// @param endpoints canvas positions
/// @return true while the pointer acts on the figure
bool PushByHand(Ui&, Session&, PushGesture&, const Touch& stage, const Camera&,
                std::span<const ImVec2> endpoints);

}  // namespace gaitsmith::shell
