// SPDX-License-Identifier: MIT
// Downhill simplex method of [Nelder Mead 1965], as the paper used it [Fukunaga 1994, section 3; Press 1992]:
// n + 1 genomes, of which the worst is reflected through the middle of the others (1), expanded (2),
// contracted (1/2), or all shrink towards the best (1/2). Every vertex lies on the 16-bit grid. When the
// simplex has shrunk to a point of it, a new one begins at the best, each edge to either side at random.
//
// From a random genome it is a lesson; it refines what another search has found. One evaluation after
// another, but for first simplices and shrinking.
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

  /// The vertices of a new simplex around this genome, without it.
  [[nodiscard]] std::vector<Genome> Edges(const Genome& start) const;
  /// middle + factor * (middle - worst), middle that of all vertices but the worst.
  [[nodiscard]] Genome Beyond(double factor) const;
  void ReplaceWorst(Individual);
  void Shrink(std::span<const Genome> batch, std::span<const Score> scores);
  [[nodiscard]] bool Collapsed() const;

  std::vector<Individual> simplex_;  // best first; one vertex at a new beginning, none at the first
  Individual reflected_;             // while it is expanded or contracted
  Move move_ = Move::kBegin;
  int beginnings_ = 0;
};

}  // namespace gaitsmith
