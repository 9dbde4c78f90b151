// SPDX-License-Identifier: MIT
// How a search's population scattered on its way: a few hundred samples of what its reports say. They come
// when reports come, so two runs of one search have different samples of the same course.
#pragma once

#include <vector>

#include "core/search/spread.h"

namespace gaitsmith::shell {

class SpreadCurve {
 public:
  static constexpr int kMostPoints = 200;

  struct Point {
    int evaluation;
    Spread spread;
  };

  /// Forgets all. @param budget of the search that begins, evaluations
  void Begin(int budget);
  /// A sample. Of those too close together only the last one stays. A search may go back to a checkpoint:
  /// what came after it is told again.
  void Add(int evaluation, const Spread& spread);
  /// In the order of evaluations, at most kMostPoints + 2.
  [[nodiscard]] const std::vector<Point>& Points() const { return points_; }

 private:
  int budget_ = 1;
  std::vector<Point> points_;
};

}  // namespace gaitsmith::shell
