// SPDX-License-Identifier: MIT
// The best-so-far curve of a search whose results arrive out of order.
#pragma once

#include <algorithm>
#include <bit>
#include <vector>

#include "core/search/search.h"

namespace gaitsmith {

class ProgressCurve {
 public:
  [[nodiscard]] const std::vector<Search::CurvePoint>& Points() const { return points_; }

  /// Adds a fitness that may be an improvement, at its evaluation in the serial order.
  void Add(int evaluation, float fitness) { pending_.push_back({evaluation, fitness}); }

  /// Completes the curve up to an evaluation. No fitness may be added at or before it afterwards.
  void SettleTo(int evaluation) {
    const auto later = std::partition(pending_.begin(), pending_.end(),
                                      [&](const auto& point) { return point.evaluation <= evaluation; });
    std::sort(pending_.begin(), later,
              [](const auto& a, const auto& b) { return a.evaluation < b.evaluation; });
    for (auto point = pending_.begin(); point != later; ++point) {
      if (points_.empty() || point->best > points_.back().best) points_.push_back(*point);
    }
    pending_.erase(pending_.begin(), later);
  }

  void Save(BitWriter& out) const {
    for (const auto* list : {&points_, &pending_}) {
      out.Put(list->size(), 32);
      for (const auto& point : *list) {
        out.Put(static_cast<std::uint32_t>(point.evaluation), 32);
        out.Put(std::bit_cast<std::uint32_t>(point.best), 32);
      }
    }
  }
  void Load(BitReader& in) {
    for (auto* list : {&points_, &pending_}) {
      list->clear();
      for (std::uint64_t left = in.Take(32); left > 0 && !in.Overrun(); --left) {
        const int evaluation = static_cast<int>(in.Take(32));
        list->push_back({evaluation, std::bit_cast<float>(static_cast<std::uint32_t>(in.Take(32)))});
      }
    }
  }

 private:
  std::vector<Search::CurvePoint> points_, pending_;
};

}  // namespace gaitsmith
