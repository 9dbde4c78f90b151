// SPDX-License-Identifier: MIT
#include "core/evolution/elites.h"

#include "core/search/batch_search.h"

namespace gaitsmith {

Elites::Elites(const ElitesSettings& settings) : settings_(settings) {
  const auto bins = static_cast<std::size_t>(settings.bins);
  cells_.resize(bins * bins * bins);
}

std::size_t Elites::CellOf(const Score& score) const {
  const int bins = settings_.bins;
  std::size_t cell = 0;
  if (!(score.fitness > kNoMotion)) return cells_.size();
  for (std::size_t term = 0; term < score.style.size(); ++term) {
    const float share = score.style[term] / settings_.most[term];
    if (!(share - share == 0.0f)) return cells_.size();
    const float least = share > 0.0f ? share : 0.0f;
    const int bin = least < 1.0f ? static_cast<int>(least * static_cast<float>(bins)) : bins - 1;
    cell = cell * static_cast<std::size_t>(bins) + static_cast<std::size_t>(bin < bins ? bin : bins - 1);
  }
  return cell;
}

void Elites::Add(const Genome& genome, const Score& score) {
  const std::size_t cell = CellOf(score);
  if (cell == cells_.size()) return;
  Elite& elite = cells_[cell];
  if (elite.genome.empty() || score.fitness > elite.score.fitness) elite = {genome, score};
}

std::vector<std::size_t> Elites::Filled() const {
  std::vector<std::size_t> filled;
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    if (!cells_[cell].genome.empty()) filled.push_back(cell);
  }
  return filled;
}

std::vector<float> Elites::Fitness() const {
  std::vector<float> fitness;
  for (const std::size_t cell : Filled()) fitness.push_back(cells_[cell].score.fitness);
  return fitness;
}

void Elites::Save(BitWriter& out) const {
  for (const Elite& elite : cells_) {
    PutGenome(out, elite.genome, elite.score.fitness);
    for (const float value : elite.score.style) out.Put(std::bit_cast<std::uint32_t>(value), 32);
  }
}

bool Elites::Load(BitReader& in, std::size_t genes) {
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    Elite& elite = cells_[cell];
    if (!TakeGenome(in, elite.genome, elite.score.fitness, genes)) return false;
    for (float& value : elite.score.style) {
      value = std::bit_cast<float>(static_cast<std::uint32_t>(in.Take(32)));
    }
    if (in.Overrun()) return true;  // the caller reports the error
    if (!elite.genome.empty() && CellOf(elite.score) != cell) return false;
  }
  return true;
}

std::optional<Elites> ElitesOf(const SearchSettings& settings, std::size_t genes,
                               std::span<const std::uint8_t> state) {
  BitReader in(state);
  BatchHead head;
  int generation = 0;
  Elites elites(settings.elites);
  if (!TakeBatchHead(in, head, settings.evaluations, genes)) return std::nullopt;
  if (!TakeCount(in, generation, settings.evaluations)) return std::nullopt;
  if (!elites.Load(in, genes)) return std::nullopt;
  if (settings.algorithm == Algorithm::kCmaMae) return elites;  // its runs follow
  ProgressCurve curve;
  curve.Load(in);
  if (in.Overrun() || !in.AtEnd()) return std::nullopt;
  return elites;
}

}  // namespace gaitsmith
