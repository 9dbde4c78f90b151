// SPDX-License-Identifier: MIT
// Stochastic population hill climbing (SPHC) [Fukunaga 1994, Figure 5]: every individual climbs
// independently, and every `reseed_interval` generations the better half replaces the worse half.
//
// An individual's climb is serial: its next proposal depends on whether the last one was accepted. To keep
// lanes and workers busy it looks ahead: the next K perturbations of the same parent are evaluated side by
// side. The first improvement in order is accepted, and the proposals after it are discarded. Improvements
// are rare, so little is wasted. The result is exactly that of the serial loop, because proposal j of slot i
// depends only on (seed, i, j) and its parent, j counts only consumed proposals, and no look-ahead crosses a
// reseeding or the end of the budget.
#pragma once

#include "core/search/progress_curve.h"
#include "core/search/search.h"

namespace gaitsmith {

class PopulationHillClimbing final : public Search {
 public:
  PopulationHillClimbing(const SearchSettings&, const SearchSpace&);

  [[nodiscard]] std::vector<Genome> Ask(int wanted) override;
  [[nodiscard]] bool AsksAhead() const override { return true; }
  using Search::Tell;
  void Tell(std::span<const Score> scores) override;
  [[nodiscard]] int Evaluations() const override;
  [[nodiscard]] bool Done() const override;
  [[nodiscard]] const Genome& BestGenome() const override;
  [[nodiscard]] float BestFitness() const override;
  [[nodiscard]] const std::vector<CurvePoint>& Curve() const override { return curve_.Points(); }
  [[nodiscard]] std::vector<float> PopulationFitness() const override;
  void Save(BitWriter&) const override;
  [[nodiscard]] Result<void> Load(BitReader&) override;

 private:
  struct Slot {
    Genome genome;  // empty until its first evaluation
    float fitness;
    int generation = 0;  // proposals consumed; also the number of the next one (0: the random start)
  };

  [[nodiscard]] int Population() const { return static_cast<int>(slots_.size()); }
  /// Number of proposals that slot i may consume, including the random start.
  [[nodiscard]] int Budget(int slot) const;
  /// Generation at which slot i must wait: the next reseeding or the end of its budget.
  [[nodiscard]] int Horizon(int slot) const;
  [[nodiscard]] Genome Propose(int slot, int proposal) const;
  [[nodiscard]] const Slot& Best() const;
  void ReseedIfDue();

  SearchSettings settings_;
  SearchSpace space_;
  std::vector<Slot> slots_;
  /// Proposals requested from one slot, starting at its generation.
  struct Asked {
    std::size_t slot;
    int count;
  };
  std::vector<std::vector<Asked>> asks_;  // not yet scored, oldest first
  int reseedings_ = 0;
  ProgressCurve curve_;
};

}  // namespace gaitsmith
