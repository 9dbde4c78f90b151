// SPDX-License-Identifier: MIT
#include "core/evolution/torus_ga.h"

namespace gaitsmith {

std::size_t TorusGa::Mate(std::size_t cell, RandomStream& random) const {
  const auto side = static_cast<std::size_t>(Settings().torus.side);
  std::size_t row = cell / side;
  std::size_t column = cell % side;
  std::size_t best = cells_.size();
  for (int step = 0; step < Settings().torus.walk_steps; ++step) {
    switch (random.Below(4)) {
      case 0:
        row = (row + 1) % side;
        break;
      case 1:
        row = (row + side - 1) % side;
        break;
      case 2:
        column = (column + 1) % side;
        break;
      default:
        column = (column + side - 1) % side;
    }
    const std::size_t here = row * side + column;
    if (best == cells_.size() || cells_[here].fitness > cells_[best].fitness) best = here;
  }
  return best;
}

std::vector<Genome> TorusGa::Propose() const {
  const int count = Settings().torus.side * Settings().torus.side;
  std::vector<Genome> batch;
  batch.reserve(static_cast<std::size_t>(count));
  for (int cell = 0; cell < count; ++cell) {
    if (cells_.empty()) {
      batch.push_back(First(cell));
      continue;
    }
    RandomStream random = Stream(cell, generation_);
    const auto own = static_cast<std::size_t>(cell);
    const Rates& rates = Settings().genetic.rates;
    const Genome& mate = cells_[Mate(own, random)].genome;
    const Genome& mother = cells_[own].genome;
    Genome child = Cross(mate, mother, Space().shape, rates, random);
    Mutate(child, Space(), Settings().variation, rates, random);
    PerturbCopy(child, mate, mother, Space(), Settings().variation, rates, random);
    batch.push_back(std::move(child));
  }
  return batch;
}

void TorusGa::Absorb(std::span<const Genome> batch, std::span<const Score> scores) {
  cells_.resize(batch.size());
  for (std::size_t i = 0; i < batch.size(); ++i) cells_[i] = {batch[i], scores[i].fitness};
  ++generation_;
}

void TorusGa::SaveState(BitWriter& out) const {
  out.Put(static_cast<std::uint32_t>(generation_), 32);
  PutPopulation(out, cells_);
}

bool TorusGa::LoadState(BitReader& in) {
  const auto side = static_cast<std::size_t>(Settings().torus.side);
  const std::size_t size = side * side;
  return TakeCount(in, generation_, Settings().evaluations) &&
         TakePopulation(in, cells_, size, Space().shape.Genes()) &&
         cells_.size() == (generation_ > 0 ? size : 0);
}

std::unique_ptr<Search> MakeMpga(const SearchSettings& settings, const SearchSpace& space) {
  return std::make_unique<TorusGa>(settings, space);
}

}  // namespace gaitsmith
