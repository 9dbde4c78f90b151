// SPDX-License-Identifier: MIT
#include "shell/results/spread_curve.h"

#include <algorithm>

namespace gaitsmith::shell {

void SpreadCurve::Begin(int budget) {
  budget_ = std::max(1, budget);
  points_.clear();
}

void SpreadCurve::Add(int evaluation, const Spread& spread) {
  while (!points_.empty() && points_.back().evaluation >= evaluation) points_.pop_back();
  // The newest point is the search's present state. The point before it must keep its distance from earlier
  // points.
  const int distance = (budget_ + kMaxPoints - 1) / kMaxPoints;
  const std::size_t count = points_.size();
  if (count > 1 && points_[count - 1].evaluation - points_[count - 2].evaluation < distance)
    points_.pop_back();
  points_.push_back({evaluation, spread});
}

}  // namespace gaitsmith::shell
