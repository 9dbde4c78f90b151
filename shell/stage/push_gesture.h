// SPDX-License-Identifier: MIT
// Pushing the figure by hand: pull an arrow out of a joint or tip, let go, and the impulse acts at that
// moment.
#pragma once

#include <span>

#include "shell/session/session.h"
#include "shell/stage/camera.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct PushGesture {
  int endpoint = kNobody;  // that the arrow starts from
  bool drawn = false;      // far enough from it to be an arrow
  bool was_playing = false;

  static constexpr int kNobody = -1;
};

/// Takes part in the stage's touch and draws the arrow. Time stands still while it is drawn.
/// @param endpoints canvas positions
/// @return true while the pointer belongs to the figure
bool PushByHand(Ui&, Session&, PushGesture&, const Touch& stage, const Camera&,
                std::span<const ImVec2> endpoints);

}  // namespace gaitsmith::shell
