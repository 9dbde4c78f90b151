// SPDX-License-Identifier: MIT
// NSGA-II [Deb et al. 2002], a genetic algorithm for two aims: the score, and as little as possible of a
// cost. It finds a front from what costs nothing to what scores most, so that a person can choose afterwards.
//
// Parents win tournaments of two, in which each member takes part twice: the better front wins, then the less
// crowded member. Parents and children compete for the places of the next generation by the same order. Void
// motions are behind all fronts.
#pragma once

#include <optional>

#include "core/evolution/front.h"
#include "core/search/batch_search.h"

namespace gaitsmith {

/// A member of the population.
struct Compromise {
  Genome genome;
  Aims aims;
};

class Nsga final : public BatchSearch {
 public:
  Nsga(const SearchSettings& settings, const SearchSpace& space) : BatchSearch(settings, space) {}
  [[nodiscard]] std::vector<float> PopulationFitness() const override;

 private:
  [[nodiscard]] std::vector<Genome> Propose() const override;
  void Absorb(std::span<const Genome> batch, std::span<const Score> scores) override;
  [[nodiscard]] bool ReadsTraits() const override { return true; }
  void SaveState(BitWriter&) const override;
  [[nodiscard]] bool LoadState(BitReader&) override;
  /// Indices of the parents of the next generation, at least as many as there are members.
  [[nodiscard]] std::vector<std::size_t> Winners() const;

  std::vector<Compromise> members_;  // best first; empty until the first generation is scored
  int generation_ = 0;
};

/// The front of a saved state of NSGA-II (Search::Save), by rising score, for those who only look at it.
/// Members that are alike in both aims are shown once.
/// @return nothing if it is not one of a search with these settings
[[nodiscard]] std::optional<std::vector<Compromise>> FrontOf(const SearchSettings&, std::size_t genes,
                                                             std::span<const std::uint8_t> state);

}  // namespace gaitsmith
