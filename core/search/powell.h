// SPDX-License-Identifier: MIT
// Powell's direction set method [Powell 1964], as in [Press 1992]: it finds the best point along each of n
// directions in turn, which are the genes at first. After a sweep, its overall direction may replace the
// direction of its largest gain. A line search brackets the top by doubling steps, then refines it by
// parabolas, within the unit cube. A sweep without gain halves the first step of its lines. When this step is
// only a few grid points, step and directions are reset.
//
// It is meant to refine what another search has found. From a random genome it is only instructive. It
// evaluates one genome at a time.
#pragma once

#include <optional>

#include "core/search/batch_search.h"

namespace gaitsmith {

class Powell final : public BatchSearch {
 public:
  Powell(const SearchSettings& settings, const SearchSpace& space);
  /// The fitness of the present point alone.
  [[nodiscard]] std::vector<float> PopulationFitness() const override;

  /// A point tried on a line. `at` is measured from the line's start, as a share of a gene's range.
  struct Trial {
    double at;
    float fitness;
  };
  /// The next point to try on a line.
  /// @param tried at least the start of the line
  /// @param low, high ends of the line
  /// @return nothing if the line is finished
  [[nodiscard]] static std::optional<double> NextTrial(std::span<const Trial> tried, double step, double low,
                                                       double high);

 private:
  enum class Phase { kFirst, kSweep, kBeyond, kExtraLine };
  using Direction = std::vector<float>;  // largest component 1; empty: along one gene, see axes_

  [[nodiscard]] std::vector<Genome> Propose() const override;
  void Absorb(std::span<const Genome> batch, std::span<const Score> scores) override;
  void SaveState(BitWriter&) const override;
  [[nodiscard]] bool LoadState(BitReader&) override;

  void ResetDirections();
  void BeginSweep();
  void BeginLine(std::size_t line);
  /// Advances to the next trial.
  void Advance();
  void FinishLine();
  void FinishSweep();
  void JudgeBeyond(float fitness);
  [[nodiscard]] std::vector<double> PointAt(double at) const;

  std::vector<Direction> directions_;
  std::vector<int> axes_;  // gene of each empty direction
  Phase phase_ = Phase::kFirst;
  double step_;
  Individual here_;   // start of the line
  Individual best_;   // best of the line
  Individual start_;  // start of the sweep
  std::size_t line_ = 0;
  std::vector<Trial> tried_;
  double next_ = 0.0;       // proposed trial
  bool any_trial_ = false;  // any trial in this sweep
  double gain_ = 0.0;       // largest gain of one line in the sweep
  std::size_t gainer_ = 0;
};

}  // namespace gaitsmith
