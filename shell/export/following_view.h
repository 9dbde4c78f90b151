// SPDX-License-Identifier: MIT
// A view that follows a motion, as films have it (web/share/film.js): what is in its middle, and the ground
// there.
#pragma once

#include <cstddef>
#include <vector>

#include "core/rollout/motion.h"
#include "core/world/terrain.h"

namespace gaitsmith::shell {

class FollowingView {
 public:
  /// @param loops the motion ends as it begins: then the view moves evenly, otherwise smoothly
  FollowingView(const Motion& motion, const Terrain& ground, bool loops);

  [[nodiscard]] int Frames() const { return static_cast<int>(middle_m_.size()); }
  [[nodiscard]] double MiddleM(int frame) const { return middle_m_[static_cast<std::size_t>(frame)]; }
  /// Height of the ground below the figure.
  [[nodiscard]] double GroundM(int frame) const { return ground_m_[static_cast<std::size_t>(frame)]; }
  [[nodiscard]] double WayM() const { return middle_m_.back() - middle_m_.front(); }
  [[nodiscard]] double LeastM() const;
  [[nodiscard]] double MostM() const;

 private:
  std::vector<double> middle_m_, ground_m_;
};

}  // namespace gaitsmith::shell
