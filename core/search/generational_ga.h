// SPDX-License-Identifier: MIT
// Generational-replacement genetic algorithm (GGA) [Fukunaga 1994, Figure 2]: parents are drawn by roulette
// wheel, and their children replace the whole population. The paper describes no elitism, so there is none:
// the best genome is remembered, but need not stay in the population.
//
// The wheel [Goldberg 1989]: a parent's chance is proportional to its fitness above that of the least fit
// real motion, because distances can be negative. If all are equal, all have the same chance.
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

/// Cumulative sums of the population's fitness above its least: a wheel to draw parents from.
[[nodiscard]] std::vector<double> RouletteWheel(const std::vector<Individual>& population);
/// An index into the wheel. @param u [0, 1)
[[nodiscard]] std::size_t SpinWheel(std::span<const double> wheel, double u);

}  // namespace gaitsmith
