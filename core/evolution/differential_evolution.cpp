// SPDX-License-Identifier: MIT
#include "core/evolution/differential_evolution.h"

#include <algorithm>
#include <array>

namespace gaitsmith {

Genome DifferentialEvolution::RivalOf(std::size_t member, RandomStream& random) const {
  const DifferenceSettings& difference = Settings().difference;
  std::array<std::size_t, 3> others{};
  for (std::size_t i = 0; i < others.size();) {
    others[i] = random.Below(static_cast<std::uint32_t>(members_.size()));
    const auto drawn = std::span(others).first(i);
    if (others[i] != member && std::ranges::find(drawn, others[i]) == drawn.end()) ++i;
  }
  const Genome& own = members_[member].genome;
  const auto gene_of = [&](std::size_t other, std::size_t gene) {
    return static_cast<double>(members_[others[other]].genome[gene]);
  };
  const std::size_t sure = random.Below(static_cast<std::uint32_t>(own.size()));
  std::vector<double> point = PointOf(own);
  for (std::size_t gene = 0; gene < own.size(); ++gene) {
    if (!random.Chance(static_cast<double>(difference.crossover)) && gene != sure) continue;
    const double moved =
        gene_of(0, gene) + static_cast<double>(difference.weight) * (gene_of(1, gene) - gene_of(2, gene));
    const double share = moved * (1.0 / kGeneMax);
    point[gene] = share >= 0.0 && share <= 1.0 ? share : random.Uniform();
  }
  return GenomeAt(point, Space().shape);
}

std::vector<Genome> DifferentialEvolution::Propose() const {
  const auto size = static_cast<std::size_t>(Settings().difference.population);
  std::vector<Genome> batch;
  batch.reserve(size);
  for (std::size_t i = 0; i < size; ++i) {
    if (members_.empty()) {
      batch.push_back(First(static_cast<int>(i)));
      continue;
    }
    RandomStream random = Stream(static_cast<int>(i), generation_);
    batch.push_back(RivalOf(i, random));
  }
  return batch;
}

void DifferentialEvolution::Absorb(std::span<const Genome> batch, std::span<const Score> scores) {
  members_.resize(batch.size());
  for (std::size_t i = 0; i < batch.size(); ++i) {
    Individual& member = members_[i];
    if (member.genome.empty() || scores[i].fitness >= member.fitness) member = {batch[i], scores[i].fitness};
  }
  ++generation_;
}

void DifferentialEvolution::SaveState(BitWriter& out) const {
  out.Put(static_cast<std::uint32_t>(generation_), 32);
  PutPopulation(out, members_);
}

bool DifferentialEvolution::LoadState(BitReader& in) {
  const auto size = static_cast<std::size_t>(Settings().difference.population);
  return TakeCount(in, generation_, Settings().evaluations) &&
         TakePopulation(in, members_, size, Space().shape.Genes()) &&
         members_.size() == (generation_ > 0 ? size : 0);
}

std::unique_ptr<Search> MakeDifferentialEvolution(const SearchSettings& settings, const SearchSpace& space) {
  return std::make_unique<DifferentialEvolution>(settings, space);
}

}  // namespace gaitsmith
