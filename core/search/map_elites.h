// SPDX-License-Identifier: MIT
// MAP-Elites [Mouret Clune 2015]: a grid over style, in every cell the fittest genome whose motion falls
// there. The style is that of the paper's three secondary terms (Table 3), so that one search yields a suite
// of motions: shuffles, hops and turns beside each other. Children are perturbed copies of elites drawn
// alike.
#pragma once

#include "core/search/batch_search.h"

namespace gaitsmith {

class MapElites final : public BatchSearch {
 public:
  MapElites(const SearchSettings& settings, const SearchSpace& space);

  struct Elite {
    Genome genome;  // empty: nobody yet
    Score score;
  };
  [[nodiscard]] std::vector<float> PopulationFitness() const override;
  /// bins^3 cells; the number of a cell is (height bin * bins + slip bin) * bins + rotations bin.
  [[nodiscard]] const std::vector<Elite>& Cells() const { return cells_; }

 private:
  [[nodiscard]] std::vector<Genome> Propose() const override;
  void Absorb(std::span<const Genome> batch, std::span<const Score> scores) override;
  void AbsorbRest(std::span<const Genome> batch, std::span<const Score> scores) override;
  void SaveState(BitWriter&) const override;
  [[nodiscard]] bool LoadState(BitReader&) override;
  /// @return Cells().size() for a style that is none
  [[nodiscard]] std::size_t CellOf(const Score&) const;

  std::vector<Elite> cells_;
  int generation_ = 0;
};

}  // namespace gaitsmith
