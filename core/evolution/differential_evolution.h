// SPDX-License-Identifier: MIT
// Differential evolution, DE/rand/1/bin [Storn Price 1997], over the unit cube of genes. In each generation
// every member x has a rival
//
//   v = a + F (b - c),   a, b, c three other members, drawn without repetition
//
// of which each gene is taken with chance CR, and one in any case; the others are those of x. A gene outside
// its range is drawn anew. The rival takes the place of x if it is no worse.
//
// Where all three members ignore a sense the difference is nothing, so the rival ignores it as well: unlike
// CMA-ES it needs no list of genes to leave alone.
#pragma once

#include "core/search/batch_search.h"

namespace gaitsmith {

class DifferentialEvolution final : public BatchSearch {
 public:
  DifferentialEvolution(const SearchSettings& settings, const SearchSpace& space)
      : BatchSearch(settings, space) {}
  [[nodiscard]] std::vector<float> PopulationFitness() const override { return FitnessOf(members_); }

 private:
  [[nodiscard]] std::vector<Genome> Propose() const override;
  void Absorb(std::span<const Genome> batch, std::span<const Score> scores) override;
  void SaveState(BitWriter&) const override;
  [[nodiscard]] bool LoadState(BitReader&) override;
  [[nodiscard]] Genome RivalOf(std::size_t member, RandomStream&) const;

  std::vector<Individual> members_;  // empty until the first generation is scored
  int generation_ = 0;
};

}  // namespace gaitsmith
