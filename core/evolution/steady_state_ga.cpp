// SPDX-License-Identifier: MIT
#include "core/evolution/steady_state_ga.h"

#include <algorithm>
#include <cmath>

namespace gaitsmith {

std::size_t LinearRank(std::size_t population, double bias, double u) {
  const double share =
      bias > 1.0 ? (bias - std::sqrt(bias * bias - 4.0 * (bias - 1.0) * u)) / (2.0 * (bias - 1.0)) : u;
  return std::min(static_cast<std::size_t>(share * static_cast<double>(population)), population - 1);
}

std::array<std::size_t, 2> SteadyStateGa::Parents(RandomStream& random) const {
  const auto bias = static_cast<double>(Settings().genetic.rank_bias);
  const std::size_t first = LinearRank(ranked_.size(), bias, random.Uniform());
  const std::size_t second = LinearRank(ranked_.size(), bias, random.Uniform());
  return {first, second};
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
  const auto [first, second] = Parents(random);
  Offspring children = Breed(ranked_[first].genome, ranked_[second].genome, Space(), Settings().variation,
                             genetic.rates, random);
  return {std::move(children.copy), std::move(children.hybrid)};
}

void SteadyStateGa::Insert(const Genome& genome, float fitness) {
  const auto place = std::ranges::upper_bound(ranked_, fitness, std::ranges::greater{}, &Individual::fitness);
  ranked_.insert(place, {genome, fitness});
}

void SteadyStateGa::Crowd(std::span<const Genome> children, std::span<const Score> scores) {
  RandomStream random = Stream(0, pair_);
  const std::array<std::size_t, 2> parents = Parents(random);
  std::array<std::size_t, 2> rivals{};
  for (std::size_t child = 0; child < 2; ++child) {
    const auto distance = [&](std::size_t parent) {
      return GeneDistance(children[child], ranked_[parent].genome);
    };
    rivals[child] = distance(parents[1]) < distance(parents[0]) ? parents[1] : parents[0];
  }
  std::vector<Individual> fitter;
  std::array<std::size_t, 2> beaten{};
  for (std::size_t child = 0; child < 2; ++child) {
    // Of one parent only one child can take the place.
    const bool taken = !fitter.empty() && beaten[0] == rivals[child];
    const float bar = taken ? fitter[0].fitness : ranked_[rivals[child]].fitness;
    if (!(scores[child].fitness > bar)) continue;
    if (taken) fitter.clear();
    beaten[fitter.size()] = rivals[child];
    fitter.push_back({children[child], scores[child].fitness});
  }
  if (fitter.size() == 2 && beaten[0] < beaten[1]) std::swap(beaten[0], beaten[1]);
  for (std::size_t i = 0; i < fitter.size(); ++i) {
    ranked_.erase(ranked_.begin() + static_cast<std::ptrdiff_t>(beaten[i]));
  }
  for (const Individual& one : fitter) Insert(one.genome, one.fitness);
}

void SteadyStateGa::Absorb(std::span<const Genome> batch, std::span<const Score> scores) {
  if (pair_ > 0 && Settings().genetic.niching == Niching::kKept) {
    Crowd(batch, scores);
    ++pair_;
    return;
  }
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
