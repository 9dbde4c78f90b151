// SPDX-License-Identifier: MIT
// Generational-replacement genetic algorithm (GGA) [Fukunaga 1994, Figure 2]: parents are drawn by roulette
// wheel, and their children replace the whole population. The paper describes no elitism, so there is none:
// the best genome is remembered, but need not stay in the population.
//
// The wheel [Goldberg 1989]: a parent's chance is proportional to its fitness above that of the least fit
// real motion, because distances can be negative. If all are equal, all have the same chance.
//
// With niching [Goldberg Richardson 1987] this is divided by how many there are of the parent's kind: the sum
// over the population of 1 - d / kNiche, where d < kNiche is the mean difference of their genes.
#pragma once

#include "core/search/batch_search.h"

namespace gaitsmith {

class GenerationalGa final : public BatchSearch {
 public:
  GenerationalGa(const SearchSettings& settings, const SearchSpace& space) : BatchSearch(settings, space) {}
  [[nodiscard]] std::vector<float> PopulationFitness() const override { return FitnessOf(population_); }

 private:
  [[nodiscard]] std::vector<Genome> Propose() const override;
  void Absorb(std::span<const Genome> batch, std::span<const Score> scores) override;
  void SaveState(BitWriter&) const override;
  [[nodiscard]] bool LoadState(BitReader&) override;

  std::vector<Individual> population_;  // empty until the first generation is scored
  int generation_ = 0;
};

/// Below this mean difference of genes, as a share of their range, two controllers are of one kind.
inline constexpr double kNiche = 0.3;
/// How many of a population are of each one's kind, itself included, so at least 1.
[[nodiscard]] std::vector<double> NicheCounts(const std::vector<Individual>& population);

/// Cumulative sums of the population's fitness above its least: a wheel to draw parents from.
/// @param shared among how many each one's fitness is shared; empty: it is not
[[nodiscard]] std::vector<double> RouletteWheel(const std::vector<Individual>& population,
                                                std::span<const double> shared = {});
/// An index into the wheel. @param u [0, 1)
[[nodiscard]] std::size_t SpinWheel(std::span<const double> wheel, double u);

}  // namespace gaitsmith
