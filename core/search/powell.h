// SPDX-License-Identifier: MIT
// Powell's direction set method [Powell 1964], as in [Press 1992]: the best point along each of n directions
// in turn, at first the genes; after a sweep, the way it went as a whole may replace the direction of its
// largest gain. A line search brackets the top by steps that double, then refines by parabolas, within the
// unit cube. A sweep without gain halves the first step of its lines; when that is a few grid points, step
// and directions are those of the beginning again.
//
// From a random genome it is a lesson; it refines what another search has found. One evaluation after
// another.
#pragma once

#include <optional>

#include "core/search/batch_search.h"

namespace gaitsmith {

class Powell final : public BatchSearch {
 public:
  Powell(const SearchSettings& settings, const SearchSpace& space);
  /// The point it has come to, alone.
  [[nodiscard]] std::vector<float> PopulationFitness() const override;

  /// A point tried on a line: `at` counts from where the line begins, in shares of a gene's range.
  struct Trial {
    double at;
    float fitness;
  };
  /// Where to try next.
  /// @param tried at least the beginning. @param low, high ends of the line. @return nothing: the line is
  /// done
  [[nodiscard]] static std::optional<double> NextTrial(std::span<const Trial> tried, double step, double low,
                                                       double high);

 private:
  enum class Phase { kFirst, kSweep, kBeyond, kExtraLine };
  using Direction = std::vector<float>;  // its largest component is 1; empty: the gene of the same number

  [[nodiscard]] std::vector<Genome> Propose() const override;
  void Absorb(std::span<const Genome> batch, std::span<const Score> scores) override;
  void SaveState(BitWriter&) const override;
  [[nodiscard]] bool LoadState(BitReader&) override;

  void ResetDirections();
  void BeginSweep();
  void BeginLine(std::size_t line);
  /// Goes on to the next trial there is.
  void Advance();
  void FinishLine();
  void FinishSweep();
  void JudgeBeyond(float fitness);
  [[nodiscard]] std::vector<double> PointAt(double at) const;

  std::vector<Direction> directions_;
  std::vector<int> axes_;  // of the directions that are empty
  Phase phase_ = Phase::kFirst;
  double step_;
  Individual here_;   // where the line begins
  Individual best_;   // of the line
  Individual start_;  // of the sweep
  std::size_t line_ = 0;
  std::vector<Trial> tried_;
  double next_ = 0.0;       // trial that is asked for
  bool any_trial_ = false;  // in this sweep
  double gain_ = 0.0;       // largest of the sweep
  std::size_t gainer_ = 0;
};

}  // namespace gaitsmith
