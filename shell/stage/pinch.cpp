// SPDX-License-Identifier: MIT
#include "shell/stage/pinch.h"

#include <algorithm>
#include <cmath>

namespace gaitsmith::shell {

bool Pinch::Take(const SDL_TouchFingerEvent& event, ImVec2 size) {
  const ImVec2 at(event.x * size.x, event.y * size.y);
  const auto finger = std::ranges::find(fingers_, event.fingerId, &Finger::id);
  if (event.type == SDL_FINGERMOTION) {
    if (finger != fingers_.end()) finger->at = at;
    return false;
  }
  if (finger != fingers_.end()) fingers_.erase(finger);
  if (event.type == SDL_FINGERUP) {
    if (fingers_.empty()) holds_ = false;
    return false;
  }
  if (!area.Contains(at)) return false;
  fingers_.push_back({.id = event.fingerId, .at = at, .before = at});
  if (fingers_.size() != 2 || holds_) return false;
  holds_ = true;
  return true;
}

Pinch::Change Pinch::TakeChange() {
  Change change;
  if (fingers_.size() != 2) return change;
  Finger& a = fingers_[0];
  Finger& b = fingers_[1];
  // Least distance of a pinch [points]: between closer fingers small tremors would change the scale too much.
  constexpr float kApart = 24.0f;
  const float before = std::hypot(a.before.x - b.before.x, a.before.y - b.before.y);
  const float now = std::hypot(a.at.x - b.at.x, a.at.y - b.at.y);
  change.zoom = std::max(now, kApart) / std::max(before, kApart);
  change.from = {0.5f * (a.before.x + b.before.x), 0.5f * (a.before.y + b.before.y)};
  change.to = {0.5f * (a.at.x + b.at.x), 0.5f * (a.at.y + b.at.y)};
  a.before = a.at;
  b.before = b.at;
  return change;
}

}  // namespace gaitsmith::shell
