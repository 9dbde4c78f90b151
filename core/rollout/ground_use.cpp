// SPDX-License-Identifier: MIT
#include "core/rollout/ground_use.h"

#include <array>

namespace gaitsmith {

GroundUse GroundUseOf(const Motion& motion) {
  const int steps = motion.Frames() - 1;
  if (steps < 1) return {};
  std::array<int, kMaxContacts> loaded{};
  int grounded = 0;
  for (int frame = 1; frame <= steps; ++frame) {
    bool any = false;
    for (int endpoint = 0; endpoint < motion.Connections().contacts; ++endpoint) {
      if (!(motion.Force(frame, endpoint).y > 0.0f)) continue;
      ++loaded[static_cast<std::size_t>(endpoint)];
      any = true;
    }
    grounded += any ? 1 : 0;
  }
  GroundUse use{.share = static_cast<float>(grounded) / static_cast<float>(steps)};
  for (const int count : loaded) use.bearers += 100 * count >= steps && count > 0 ? 1 : 0;
  return use;
}

}  // namespace gaitsmith
