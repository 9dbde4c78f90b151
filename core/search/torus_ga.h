// SPDX-License-Identifier: MIT
// Massively parallel genetic algorithm (MPGA) [Fukunaga 1994, Figure 1; Ngo 1993]: one genome on each
// processor of a torus; in every generation each is crossed with a mate from nearby, mutated and replaced by
// the child, all at once. The mate is the fittest met on a random walk, after [Collins Jefferson 1991], our
// reading of "select mate genome from a nearby processor". The child is a hybrid that has its processor's own
// genome as base.
#pragma once

#include "core/search/batch_search.h"

namespace gaitsmith {

class TorusGa final : public BatchSearch {
 public:
  TorusGa(const SearchSettings& settings, const SearchSpace& space) : BatchSearch(settings, space) {}
  [[nodiscard]] std::vector<float> PopulationFitness() const override { return FitnessOf(cells_); }

 private:
  [[nodiscard]] std::vector<Genome> Propose() const override;
  void Absorb(std::span<const Genome> batch, std::span<const Score> scores) override;
  void SaveState(BitWriter&) const override;
  [[nodiscard]] bool LoadState(BitReader&) override;

  /// The fittest cell on a walk that begins beside `cell`; of equals the one met first.
  [[nodiscard]] std::size_t Mate(std::size_t cell, RandomStream& random) const;

  std::vector<Individual> cells_;  // row after row; empty before the first generation is known
  int generation_ = 0;
};

}  // namespace gaitsmith
