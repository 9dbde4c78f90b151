// SPDX-License-Identifier: MIT
// Downhill simplex method of [Nelder Mead 1965], as used in the paper [Fukunaga 1994, section 3; Press 1992].
// The worst of n + 1 genomes is reflected through the middle of the others (factor 1), expanded (2) or
// contracted (1/2), or all shrink towards the best (1/2). Every vertex is rounded to the 16-bit grid. When
// the simplex has shrunk to one grid point, a new one begins at the best, with each edge to a random side.
//
// It is meant to refine what another search has found. From a random genome it is only instructive. It
// evaluates one genome at a time, except for new simplices and shrinking.
#pragma once

#include "core/search/batch_search.h"

namespace gaitsmith {

class NelderMead final : public BatchSearch {
 public:
  NelderMead(const SearchSettings& settings, const SearchSpace& space) : BatchSearch(settings, space) {}
  [[nodiscard]] std::vector<float> PopulationFitness() const override { return FitnessOf(simplex_); }

 private:
  enum class Move { kBegin, kReflect, kExpand, kContract, kShrink };

  [[nodiscard]] std::vector<Genome> Propose() const override;
  void Absorb(std::span<const Genome> batch, std::span<const Score> scores) override;
  void SaveState(BitWriter&) const override;
  [[nodiscard]] bool LoadState(BitReader&) override;

  /// The vertices of a new simplex around this genome, without the genome itself.
  [[nodiscard]] std::vector<Genome> Edges(const Genome& start) const;
  /// middle + factor * (middle - worst), where middle is the mean of all vertices except the worst.
  [[nodiscard]] Genome Beyond(double factor) const;
  void ReplaceWorst(Individual);
  void Shrink(std::span<const Genome> batch, std::span<const Score> scores);
  [[nodiscard]] bool Collapsed() const;

  std::vector<Individual> simplex_;  // best first; one vertex at a restart, none at the start
  Individual reflected_;             // set while it is expanded or contracted
  Move move_ = Move::kBegin;
  int beginnings_ = 0;
};

}  // namespace gaitsmith
