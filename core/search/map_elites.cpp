// SPDX-License-Identifier: MIT
#include "core/search/map_elites.h"

namespace gaitsmith {

MapElites::MapElites(const SearchSettings& settings, const SearchSpace& space)
    : BatchSearch(settings, space) {
  const auto bins = static_cast<std::size_t>(settings.elites.bins);
  cells_.resize(bins * bins * bins);
}

std::size_t MapElites::CellOf(const Score& score) const {
  const int bins = Settings().elites.bins;
  std::size_t cell = 0;
  if (!(score.fitness > kNoMotion)) return cells_.size();
  for (std::size_t term = 0; term < score.style.size(); ++term) {
    const float share = score.style[term] / Settings().elites.most[term];
    if (!(share - share == 0.0f)) return cells_.size();
    const float least = share > 0.0f ? share : 0.0f;
    const int bin = least < 1.0f ? static_cast<int>(least * static_cast<float>(bins)) : bins - 1;
    cell = cell * static_cast<std::size_t>(bins) + static_cast<std::size_t>(bin < bins ? bin : bins - 1);
  }
  return cell;
}

std::vector<float> MapElites::PopulationFitness() const {
  std::vector<float> fitness;
  for (const Elite& elite : cells_) {
    if (!elite.genome.empty()) fitness.push_back(elite.score.fitness);
  }
  return fitness;
}

std::vector<Genome> MapElites::Propose() const {
  std::vector<Genome> batch;
  const ElitesSettings& elites = Settings().elites;
  if (generation_ == 0) {
    for (int i = 0; i < elites.initial; ++i) batch.push_back(First(i));
    return batch;
  }
  std::vector<std::size_t> filled;
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    if (!cells_[cell].genome.empty()) filled.push_back(cell);
  }
  for (int i = 0; i < elites.batch; ++i) {
    RandomStream random = Stream(i, generation_);
    const Variation& variation = Settings().variation;
    if (filled.empty()) {
      batch.push_back(RandomGenome(Space().shape, Space().senses, variation, random));
      continue;
    }
    const Genome& parent = cells_[filled[random.Below(static_cast<std::uint32_t>(filled.size()))]].genome;
    batch.push_back(Perturb(parent, Space().shape, Space().senses, variation, random));
  }
  return batch;
}

void MapElites::AbsorbRest(std::span<const Genome> batch, std::span<const Score> scores) {
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const std::size_t cell = CellOf(scores[i]);
    if (cell == cells_.size()) continue;
    Elite& elite = cells_[cell];
    if (elite.genome.empty() || scores[i].fitness > elite.score.fitness) elite = {batch[i], scores[i]};
  }
}

void MapElites::Absorb(std::span<const Genome> batch, std::span<const Score> scores) {
  AbsorbRest(batch, scores);
  ++generation_;
}

void MapElites::SaveState(BitWriter& out) const {
  out.Put(static_cast<std::uint32_t>(generation_), 32);
  for (const Elite& elite : cells_) {
    PutGenome(out, elite.genome, elite.score.fitness);
    for (const float value : elite.score.style) out.Put(std::bit_cast<std::uint32_t>(value), 32);
  }
}

bool MapElites::LoadState(BitReader& in) {
  if (!TakeCount(in, generation_, Settings().evaluations)) return false;
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    Elite& elite = cells_[cell];
    if (!TakeGenome(in, elite.genome, elite.score.fitness, Space().shape.Genes())) return false;
    for (float& value : elite.score.style) {
      value = std::bit_cast<float>(static_cast<std::uint32_t>(in.Take(32)));
    }
    if (in.Overrun()) return true;  // the caller reports the error
    if (!elite.genome.empty() && CellOf(elite.score) != cell) return false;
  }
  return true;
}

std::unique_ptr<Search> MakeMapElites(const SearchSettings& settings, const SearchSpace& space) {
  return std::make_unique<MapElites>(settings, space);
}

}  // namespace gaitsmith
