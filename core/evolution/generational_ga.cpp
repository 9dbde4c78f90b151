// SPDX-License-Identifier: MIT
#include "core/evolution/generational_ga.h"

#include <algorithm>

namespace gaitsmith {

std::vector<double> NicheCounts(const std::vector<Individual>& population) {
  std::vector<double> counts(population.size(), 1.0);
  for (std::size_t i = 0; i < population.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double near = 1.0 - GeneDistance(population[i].genome, population[j].genome) / kNiche;
      if (!(near > 0.0)) continue;
      counts[i] += near;
      counts[j] += near;
    }
  }
  return counts;
}

std::vector<double> RouletteWheel(const std::vector<Individual>& population, std::span<const double> shared) {
  float least = std::numeric_limits<float>::infinity();
  for (const Individual& one : population) {
    if (one.fitness > kNoMotion) least = std::min(least, one.fitness);
  }
  std::vector<double> wheel;
  wheel.reserve(population.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < population.size(); ++i) {
    const float fitness = population[i].fitness;
    if (fitness > least) {
      sum += (static_cast<double>(fitness) - static_cast<double>(least)) / (shared.empty() ? 1.0 : shared[i]);
    }
    wheel.push_back(sum);
  }
  return wheel;
}

std::size_t SpinWheel(std::span<const double> wheel, double u) {
  const double sum = wheel.back();
  if (!(sum > 0.0)) return static_cast<std::size_t>(u * static_cast<double>(wheel.size()));
  const auto found = std::ranges::upper_bound(wheel, u * sum);
  return std::min(static_cast<std::size_t>(found - wheel.begin()), wheel.size() - 1);
}

std::vector<Genome> GenerationalGa::Propose() const {
  const auto size = static_cast<std::size_t>(Settings().genetic.population);
  std::vector<Genome> batch;
  batch.reserve(size + 1);
  if (population_.empty()) {
    for (int i = 0; std::cmp_less(i, size); ++i) batch.push_back(First(i));
    return batch;
  }
  const bool niches = Settings().genetic.niching == Niching::kKept;
  const std::vector<double> wheel =
      RouletteWheel(population_, niches ? NicheCounts(population_) : std::vector<double>{});
  for (int pair = 0; batch.size() < size; ++pair) {
    RandomStream random = Stream(pair, generation_);
    const Genome& first = population_[SpinWheel(wheel, random.Uniform())].genome;
    const Genome& second = population_[SpinWheel(wheel, random.Uniform())].genome;
    Offspring children =
        Breed(first, second, Space(), Settings().variation, Settings().genetic.rates, random);
    batch.push_back(std::move(children.copy));
    batch.push_back(std::move(children.hybrid));
  }
  batch.resize(size);  // for an odd population the last hybrid is dropped
  return batch;
}

void GenerationalGa::Absorb(std::span<const Genome> batch, std::span<const Score> scores) {
  population_.resize(batch.size());
  for (std::size_t i = 0; i < batch.size(); ++i) population_[i] = {batch[i], scores[i].fitness};
  ++generation_;
}

void GenerationalGa::SaveState(BitWriter& out) const {
  out.Put(static_cast<std::uint32_t>(generation_), 32);
  PutPopulation(out, population_);
}

bool GenerationalGa::LoadState(BitReader& in) {
  const auto size = static_cast<std::size_t>(Settings().genetic.population);
  return TakeCount(in, generation_, Settings().evaluations) &&
         TakePopulation(in, population_, size, Space().shape.Genes()) &&
         population_.size() == (generation_ > 0 ? size : 0);
}

std::unique_ptr<Search> MakeGga(const SearchSettings& settings, const SearchSpace& space) {
  return std::make_unique<GenerationalGa>(settings, space);
}

}  // namespace gaitsmith
