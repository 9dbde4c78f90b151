// SPDX-License-Identifier: MIT
#include "core/search/steady_state_ga.h"

#include <algorithm>
#include <cmath>

namespace gaitsmith {

std::size_t LinearRank(std::size_t population, double bias, double u) {
  const double share =
      bias > 1.0 ? (bias - std::sqrt(bias * bias - 4.0 * (bias - 1.0) * u)) / (2.0 * (bias - 1.0)) : u;
  return std::min(static_cast<std::size_t>(share * static_cast<double>(population)), population - 1);
}

std::vector<Genome> SteadyStateGa::Propose() const {
  const GeneticSettings& genetic = Settings().genetic;
  if (ranked_.empty()) {
    std::vector<Genome> batch;
    batch.reserve(static_cast<std::size_t>(genetic.population));
    for (int i = 0; i < genetic.population; ++i) batch.push_back(First(i));
    return batch;
  }
  RandomStream random = Stream(0, pair_);
  const auto bias = static_cast<double>(genetic.rank_bias);
  const Genome& first = ranked_[LinearRank(ranked_.size(), bias, random.Uniform())].genome;
  const Genome& second = ranked_[LinearRank(ranked_.size(), bias, random.Uniform())].genome;
  Offspring children = Breed(first, second, Space(), Settings().variation, genetic.rates, random);
  return {std::move(children.copy), std::move(children.hybrid)};
}

void SteadyStateGa::Insert(const Genome& genome, float fitness) {
  const auto place = std::ranges::upper_bound(ranked_, fitness, std::ranges::greater{}, &Individual::fitness);
  ranked_.insert(place, {genome, fitness});
}

void SteadyStateGa::Absorb(std::span<const Genome> batch, std::span<const Score> scores) {
  for (std::size_t i = 0; i < batch.size(); ++i) Insert(batch[i], scores[i].fitness);
  ranked_.resize(static_cast<std::size_t>(Settings().genetic.population));
  ++pair_;
}

void SteadyStateGa::SaveState(BitWriter& out) const {
  out.Put(static_cast<std::uint32_t>(pair_), 32);
  PutPopulation(out, ranked_);
}

bool SteadyStateGa::LoadState(BitReader& in) {
  const auto size = static_cast<std::size_t>(Settings().genetic.population);
  return TakeCount(in, pair_, Settings().evaluations) &&
         TakePopulation(in, ranked_, size, Space().shape.Genes()) &&
         ranked_.size() == (pair_ > 0 ? size : 0) &&
         std::ranges::is_sorted(ranked_, std::ranges::greater{}, &Individual::fitness);
}

std::unique_ptr<Search> MakeSsga(const SearchSettings& settings, const SearchSpace& space) {
  return std::make_unique<SteadyStateGa>(settings, space);
}

}  // namespace gaitsmith
