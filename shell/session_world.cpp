// SPDX-License-Identifier: MIT
// The session's part in the world around the figure: pushes, ground and gravity, and the ghost to compare
// with.
#include <algorithm>
#include <cmath>

#include "shell/session.h"
#include "shell/wording.h"

namespace gaitsmith::shell {

namespace {

Document InWorld(Document document, const Document& other) {
  document.environment = other.environment;
  document.pushes = other.pushes;
  return document;
}

}  // namespace

bool Session::Kick(int endpoint, float impulse_x_ns, float impulse_y_ns) {
  const int step = std::min(player.Frame(), kMaxSteps - 1);
  const bool pushed = Change([&](Document& d) {
    const Push push{
        .step = step, .endpoint = endpoint, .impulse_x_ns = impulse_x_ns, .impulse_y_ns = impulse_y_ns};
    const auto after = std::ranges::upper_bound(d.pushes, step, {}, &Push::step);
    d.pushes.insert(after, push);
  });
  if (pushed) {
    host_.Status("Pushed with " + Fixed(std::hypot(impulse_x_ns, impulse_y_ns), 1) + " N s at " +
                 Fixed(static_cast<float>(step) * kStep, 2) + " s.");
  }
  return pushed;
}

void Session::RemovePush(std::size_t index) {
  Change([&](Document& d) { d.pushes.erase(d.pushes.begin() + static_cast<std::ptrdiff_t>(index)); });
}

bool Session::WorldChanged() const {
  return document_.environment != calm_.environment || document_.pushes != calm_.pushes;
}

void Session::ResetWorld() {
  Change([&](Document& d) { d = InWorld(std::move(d), calm_); });
}

void Session::ChooseGhost(int choice) {
  ghost_ = std::clamp(choice, kNoGhost, static_cast<int>(document_.controllers.size()) - 1);
  LoadGhost();
  host_.DocumentChanged(document_.title);
}

void Session::LoadGhost() {
  if (ghost_ >= static_cast<int>(document_.controllers.size())) ghost_ = kNoGhost;
  if (ghost_ == kEarlierGhost && !SameRods(earlier_.figure, document_.figure)) ghost_ = kNoGhost;
  if (ghost_ == kNoGhost) return;
  Document document = document_;
  if (ghost_ == kEarlierGhost) {
    document = InWorld(earlier_, document_);
  } else if (ghost_ == kCalmGhost) {
    document = InWorld(std::move(document), calm_);
  } else {
    document.timeline = {{.controller = ghost_, .start_step = 0}};
  }
  ghost_player_.Load(document, false);
}

}  // namespace gaitsmith::shell
