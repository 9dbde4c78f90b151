// SPDX-License-Identifier: MIT
// Two fingers on the stage: together they move the picture, apart they enlarge it.
#pragma once

#include <SDL_events.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <vector>

namespace gaitsmith::shell {

class Pinch {
 public:
  /// Fingers count when they come down here [points]; elsewhere they are one finger's business.
  ImRect area;

  /// @param size of the canvas [points]. @return true when a second finger has just made a pinch of it, so
  /// that whatever the first one had begun must end
  bool Take(const SDL_TouchFingerEvent&, ImVec2 size);
  /// From the second finger's coming until the last one has left: what remains of a pinch is no tap.
  [[nodiscard]] bool Holds() const { return holds_; }

  struct Change {
    float zoom = 1.0f;    // how many times as far apart
    ImVec2 from{}, to{};  // the middle between the fingers
  };
  /// What the fingers have done since they were last asked; nothing unless there are two.
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
