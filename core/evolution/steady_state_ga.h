// SPDX-License-Identifier: MIT
// Steady-state genetic algorithm (SSGA) [Fukunaga 1994, Figure 3]: two parents chosen by rank have two
// children, which are inserted into the ranked population. The two lowest ranks are deleted. The evaluations
// of the first population count towards the budget.
//
// Linear rank selection [Whitley 1989]: of P ranks, best first, the chosen rank is
//   floor(P (b - sqrt(b^2 - 4 (b - 1) u)) / (2 (b - 1))),   u uniform in [0, 1)
// so that the fittest has b times the chance of the median. Ties keep their order, older ones first.
//
// With niching by crowding [Mahfoud 1995] a child instead competes with the parent that it is more like, and
// takes its place only if it is fitter. Mahfoud lets the two children compete with different parents. Here
// both may be like the same one, since one of them is a copy; then the fitter one may take its place.
//
// Every pair depends on the insertion of the previous pair, so that at most two genomes are proposed at a
// time.
#pragma once

#include <array>

#include "core/search/batch_search.h"

namespace gaitsmith {

class SteadyStateGa final : public BatchSearch {
 public:
  SteadyStateGa(const SearchSettings& settings, const SearchSpace& space) : BatchSearch(settings, space) {}
  [[nodiscard]] std::vector<float> PopulationFitness() const override { return FitnessOf(ranked_); }

 private:
  [[nodiscard]] std::vector<Genome> Propose() const override;
  void Absorb(std::span<const Genome> batch, std::span<const Score> scores) override;
  void SaveState(BitWriter&) const override;
  [[nodiscard]] bool LoadState(BitReader&) override;
  void Insert(const Genome&, float fitness);
  /// The ranks of the next pair's parents. @param random of the pair
  [[nodiscard]] std::array<std::size_t, 2> Parents(RandomStream& random) const;
  void Crowd(std::span<const Genome> children, std::span<const Score> scores);

  std::vector<Individual> ranked_;  // best first; empty until the first population is scored
  int pair_ = 0;                    // iterations started; 0: the first population
};

/// Rank chosen by a uniform random number. @param bias [1, 2]; 1: equal chances. @param u [0, 1)
[[nodiscard]] std::size_t LinearRank(std::size_t population, double bias, double u);

}  // namespace gaitsmith
