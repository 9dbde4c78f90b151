// SPDX-License-Identifier: MIT
// MAP-Elites [Mouret Clune 2015]: a grid over style that keeps in each cell the fittest genome whose motion
// has this style. The axes are the paper's three secondary terms (Table 3), so one search yields a suite of
// motions: shuffles, hops and turns. Children are perturbed copies of elites, drawn with equal chance, or of
// hybrids of two, which have whole rules of each.
#pragma once

#include "core/evolution/elites.h"
#include "core/search/batch_search.h"

namespace gaitsmith {

class MapElites final : public BatchSearch {
 public:
  MapElites(const SearchSettings& settings, const SearchSpace& space);

  [[nodiscard]] std::vector<float> PopulationFitness() const override { return elites_.Fitness(); }
  /// As Elites::Cells.
  [[nodiscard]] const std::vector<Elite>& Cells() const { return elites_.Cells(); }

 private:
  [[nodiscard]] std::vector<Genome> Propose() const override;
  void Absorb(std::span<const Genome> batch, std::span<const Score> scores) override;
  void AbsorbRest(std::span<const Genome> batch, std::span<const Score> scores) override;
  void SaveState(BitWriter&) const override;
  [[nodiscard]] bool LoadState(BitReader&) override;

  Elites elites_;
  int generation_ = 0;
};

}  // namespace gaitsmith
