// SPDX-License-Identifier: MIT
// Looks for the cycle of the shown motion, once that has stayed as it is for a moment.
#pragma once

#include <optional>

#include "core/gait/closed_loop.h"
#include "shell/workspace/workspace.h"

namespace gaitsmith::shell {

class GaitFinder {
 public:
  explicit GaitFinder(const Workspace& workspace) : workspace_(workspace) {}

  /// Call once a frame. @param seconds since the last call @return true if a cycle was found or is gone
  bool Advance(double seconds);
  /// Where the shown motion repeats; nothing if it does not, or is still changing.
  [[nodiscard]] const std::optional<GaitCycle>& Cycle() const { return cycle_; }
  /// How far it comes along the ground in one cycle [m].
  [[nodiscard]] double DistanceM() const { return distance_m_; }

 private:
  const Workspace& workspace_;
  std::uint64_t hash_ = 0;  // of the motion that was looked at
  double rested_s_ = 0.0;   // since it changed
  bool looked_ = false;
  std::optional<GaitCycle> cycle_;
  double distance_m_ = 0.0;
};

}  // namespace gaitsmith::shell
