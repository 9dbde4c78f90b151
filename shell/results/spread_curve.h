// SPDX-License-Identifier: MIT
// The spread of a search's population over time, as a few hundred samples. Samples are taken when reports
// arrive, so two runs of one search sample the same data at different points.
#pragma once

#include <vector>

#include "core/search/spread.h"

namespace gaitsmith::shell {

class SpreadCurve {
 public:
  static constexpr int kMaxPoints = 200;

  struct Point {
    int evaluation;
    Spread spread;
  };

  /// Clears the curve. @param budget of the new search, in evaluations
  void Begin(int budget);
  /// Adds a sample. Of samples too close together only the last stays. After a search returns to a
  /// checkpoint, its samples from there on arrive again.
  void Add(int evaluation, const Spread& spread);
  /// In the order of evaluations, at most kMaxPoints + 2.
  [[nodiscard]] const std::vector<Point>& Points() const { return points_; }

 private:
  int budget_ = 1;
  std::vector<Point> points_;
};

}  // namespace gaitsmith::shell
