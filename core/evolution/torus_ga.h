// SPDX-License-Identifier: MIT
// Massively parallel genetic algorithm (MPGA) [Fukunaga 1994, Figure 1; Ngo 1993]: a torus with one genome on
// each processor. In every generation each genome is crossed with a mate from nearby, mutated and replaced by
// the child, all at once. The mate is the fittest genome found on a random walk, after
// [Collins Jefferson 1991]. This is our interpretation of "select mate genome from a nearby processor". The
// child is a hybrid based on its processor's own genome.
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

  /// The fittest cell on a random walk that starts next to `cell`. Of equally fit cells, the first one on the
  /// walk.
  [[nodiscard]] std::size_t Mate(std::size_t cell, RandomStream& random) const;

  std::vector<Individual> cells_;  // row by row; empty until the first generation is scored
  int generation_ = 0;
};

}  // namespace gaitsmith
