// SPDX-License-Identifier: MIT
// The session's part in the world around the figure: pushes, ground and gravity.
#include <algorithm>
#include <cmath>

#include "shell/session/session.h"
#include "shell/words/language.h"
#include "shell/words/wording.h"

namespace gaitsmith::shell {

bool Session::Kick(int endpoint, float impulse_x_ns, float impulse_y_ns) {
  const int step = std::min(player.Frame(), kMaxSteps - 1);
  const bool pushed = Change([&](Document& d) {
    const Push push{
        .step = step, .endpoint = endpoint, .impulse_x_ns = impulse_x_ns, .impulse_y_ns = impulse_y_ns};
    const auto after = std::ranges::upper_bound(d.pushes, step, {}, &Push::step);
    d.pushes.insert(after, push);
  });
  if (pushed) {
    host_.Status(Tr("Pushed with {1} N s at {2} s.", Fixed(std::hypot(impulse_x_ns, impulse_y_ns), 1),
                    Fixed(static_cast<float>(step) * kStep, 2)));
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
  Change([&](Document& d) {
    d.environment = calm_.environment;
    d.pushes = calm_.pushes;
  });
}

}  // namespace gaitsmith::shell
