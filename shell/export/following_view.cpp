// SPDX-License-Identifier: MIT
// The smoothed way of a figure and the ground below it.
#include "shell/export/following_view.h"

#include <algorithm>
#include <utility>

#include "core/world/ground_view.h"

namespace gaitsmith::shell {

namespace {

/// Two moving averages over one second.
std::vector<double> Smooth(std::vector<double> values) {
  const std::size_t count = values.size();
  std::vector<double> sums(count + 1, 0.0);
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t i = 0; i < count; ++i) sums[i + 1] = sums[i] + values[i];
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t half = std::min({std::size_t{50}, i, count - 1 - i});
      values[i] = (sums[i + half + 1] - sums[i - half]) / static_cast<double>(2 * half + 1);
    }
  }
  return values;
}

}  // namespace

FollowingView::FollowingView(const Motion& motion, const Terrain& ground, bool loops) {
  const auto frames = static_cast<std::size_t>(motion.Frames());
  middle_m_.reserve(frames);
  ground_m_.reserve(frames);
  for (int frame = 0; frame < motion.Frames(); ++frame) {
    middle_m_.push_back(motion.At(frame).x_m);
    ground_m_.push_back(HeightBelow(ground, motion.At(frame).x_m));
  }
  if (!ground.Level()) ground_m_ = Smooth(std::move(ground_m_));
  if (!loops) {
    middle_m_ = Smooth(std::move(middle_m_));
    return;
  }
  const double way = WayM();
  for (std::size_t i = 0; i < frames; ++i)
    middle_m_[i] = middle_m_[0] + way * static_cast<double>(i) / static_cast<double>(frames - 1);
}

double FollowingView::LeastM() const { return std::ranges::min(middle_m_); }
double FollowingView::MostM() const { return std::ranges::max(middle_m_); }

}  // namespace gaitsmith::shell
