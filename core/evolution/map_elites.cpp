// SPDX-License-Identifier: MIT
#include "core/evolution/map_elites.h"

namespace gaitsmith {

MapElites::MapElites(const SearchSettings& settings, const SearchSpace& space)
    : BatchSearch(settings, space), elites_(settings.elites) {}

std::vector<Genome> MapElites::Propose() const {
  std::vector<Genome> batch;
  const ElitesSettings& elites = Settings().elites;
  if (generation_ == 0) {
    for (int i = 0; i < elites.initial; ++i) batch.push_back(First(i));
    return batch;
  }
  const std::vector<std::size_t> filled = elites_.Filled();
  for (int i = 0; i < elites.batch; ++i) {
    RandomStream random = Stream(i, generation_);
    const Variation& variation = Settings().variation;
    if (filled.empty()) {
      batch.push_back(RandomGenome(Space().shape, Space().senses, variation, random));
      continue;
    }
    const auto draw = [&]() -> const Genome& {
      return Cells()[filled[random.Below(static_cast<std::uint32_t>(filled.size()))]].genome;
    };
    Genome parent = draw();
    if (elites.crossover > 0.0f && random.Chance(static_cast<double>(elites.crossover))) {
      Rates whole;
      whole.crossover = 1.0f;
      parent = Cross(draw(), parent, Space().shape, whole, random);
    }
    batch.push_back(Perturb(parent, Space().shape, Space().senses, variation, random));
  }
  return batch;
}

void MapElites::AbsorbRest(std::span<const Genome> batch, std::span<const Score> scores) {
  for (std::size_t i = 0; i < batch.size(); ++i) elites_.Add(batch[i], scores[i]);
}

void MapElites::Absorb(std::span<const Genome> batch, std::span<const Score> scores) {
  AbsorbRest(batch, scores);
  ++generation_;
}

void MapElites::SaveState(BitWriter& out) const {
  out.Put(static_cast<std::uint32_t>(generation_), 32);
  elites_.Save(out);
}

bool MapElites::LoadState(BitReader& in) {
  return TakeCount(in, generation_, Settings().evaluations) && elites_.Load(in, Space().shape.Genes());
}

std::unique_ptr<Search> MakeMapElites(const SearchSettings& settings, const SearchSpace& space) {
  return std::make_unique<MapElites>(settings, space);
}

}  // namespace gaitsmith
