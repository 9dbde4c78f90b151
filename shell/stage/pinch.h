// SPDX-License-Identifier: MIT
// Two fingers on the stage: moving both moves the picture, spreading them enlarges it.
#pragma once

#include <SDL_events.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <vector>

namespace gaitsmith::shell {

class Pinch {
 public:
  /// Only fingers that touch down in this area belong to a pinch [points].
  ImRect area;

  /// @param size of the canvas [points]. @return true if a second finger has just started a pinch, which
  /// cancels the first finger's action
  bool Take(const SDL_TouchFingerEvent&, ImVec2 size);
  /// True from the second finger's touch until the last finger is lifted, so that the end of a pinch does not
  /// count as a tap.
  [[nodiscard]] bool Holds() const { return holds_; }

  struct Change {
    float zoom = 1.0f;    // ratio of the distances between the fingers
    ImVec2 from{}, to{};  // midpoint between the fingers, before and after
  };
  /// The fingers' movement since the last call; nothing unless there are two.
  [[nodiscard]] Change TakeChange();

 private:
  struct Finger {
    SDL_FingerID id;
    ImVec2 at, before;
  };
  std::vector<Finger> fingers_;
  bool holds_ = false;
};

}  // namespace gaitsmith::shell
