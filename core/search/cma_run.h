// SPDX-License-Identifier: MIT
// One run of CMA-ES [Hansen 2016] over the unit cube of genes, from one genome. Samples are rounded to the
// nearest genome before they are used, so the distribution learns from what was simulated.
//
// The genome that a run begins at also determines which senses its rules ignore: an interval over the whole
// range is a switch, not a number. Noise on it would make every rule use every sense, so that no rule would
// ever match.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/search/cma_distribution.h"
#include "core/search/search.h"

namespace gaitsmith {

class CmaRun {
 public:
  /// Not begun.
  CmaRun() = default;
  /// @param origin     where it begins
  /// @param settings   which genes, which covariance and, if the population is 0, the usual one
  /// @param population samples of a generation; less than the usual: the usual
  /// @param step       first standard deviation, as a share of a gene's range
  CmaRun(Genome origin, const ControllerShape&, const CmaSettings& settings, int population, double step);

  [[nodiscard]] bool Begun() const { return !origin_.empty(); }
  [[nodiscard]] const Genome& Origin() const { return origin_; }
  [[nodiscard]] int Population() const { return distribution_.Population(); }
  [[nodiscard]] std::size_t FreeGenes() const { return free_.size(); }

  [[nodiscard]] Genome Sample(const ControllerShape&, RandomStream&) const;
  /// @param batch of samples. @param order of its members, best first. @param age generations so far, from 1
  void Learn(std::span<const Genome> batch, std::span<const std::size_t> order, int age);
  /// Whether it should end. @param stale generations without an improvement
  [[nodiscard]] bool Over(int stale) const;

  /// The distribution alone: what a run was begun with is known to its search.
  void Save(BitWriter& out) const { distribution_.Save(out); }
  /// Into a run that was begun with the same. @return false if this cannot be its state
  [[nodiscard]] bool Load(BitReader& in) { return distribution_.Load(in); }

 private:
  [[nodiscard]] std::vector<double> FreePointOf(const Genome&) const;

  Genome origin_;                  // empty: not begun
  std::vector<std::size_t> free_;  // genes that are searched
  CmaDistribution distribution_;   // over the free genes
};

/// The members of a batch, best first. Equal ones keep their order.
/// @param value of a member by its index
template <class Value>
[[nodiscard]] std::vector<std::size_t> BestFirst(std::size_t count, const Value& value) {
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = i;
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    return value(a) != value(b) ? value(a) > value(b) : a < b;
  });
  return order;
}

}  // namespace gaitsmith
