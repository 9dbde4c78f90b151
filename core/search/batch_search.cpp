// SPDX-License-Identifier: MIT
#include "core/search/batch_search.h"

#include <algorithm>

namespace gaitsmith {

namespace {

void PutScore(BitWriter& out, const Score& score) {
  for (const float value : {score.fitness, score.style[0], score.style[1], score.style[2]}) {
    out.Put(std::bit_cast<std::uint32_t>(value), 32);
  }
}

// Traits of a motion that broke physics need not be finite.
void TakeBits(BitReader& in, Traits& traits) {
  for (float& value : traits) value = std::bit_cast<float>(static_cast<std::uint32_t>(in.Take(32)));
}

Score TakeScore(BitReader& in) {
  Score score{};
  for (float* value : {&score.fitness, &score.style[0], &score.style[1], &score.style[2]}) {
    *value = std::bit_cast<float>(static_cast<std::uint32_t>(in.Take(32)));
  }
  return score;
}

}  // namespace

std::vector<Genome> BatchSearch::Ask(int wanted) {
  if (batch_.empty()) batch_ = Propose();
  const auto left = std::min(batch_.size() - head_.scores.size(),
                             static_cast<std::size_t>(settings_.evaluations - head_.evaluations));
  const auto first = batch_.begin() + static_cast<std::ptrdiff_t>(head_.scores.size());
  return {first,
          first + static_cast<std::ptrdiff_t>(std::min(left, static_cast<std::size_t>(std::max(1, wanted))))};
}

void BatchSearch::Tell(std::span<const Score> scores) {
  if (scores.empty()) return;
  for (Score score : scores) {
    // NaN ranks below every other fitness, and no motion is infinitely good.
    if (!(score.fitness < std::numeric_limits<float>::infinity())) {
      score.fitness = -std::numeric_limits<float>::infinity();
    }
    const bool better = score.fitness > head_.best_fitness;
    ++head_.evaluations;
    if (better || head_.best.empty()) {
      head_.best = batch_[head_.scores.size()];
      head_.best_fitness = score.fitness;
      curve_.Add(head_.evaluations, head_.best_fitness);
    }
    head_.scores.push_back(score);
  }
  curve_.SettleTo(head_.evaluations);
  if (head_.scores.size() < batch_.size()) {
    if (Done()) AbsorbRest(std::span(batch_).first(head_.scores.size()), head_.scores);
    return;
  }
  Absorb(batch_, head_.scores);
  batch_.clear();
  head_.scores.clear();
}

void BatchSearch::Save(BitWriter& out) const {
  out.Put(static_cast<std::uint32_t>(head_.evaluations), 32);
  PutGenome(out, head_.best, head_.best_fitness);
  out.Put(head_.scores.size(), 32);
  for (const Score& score : head_.scores) {
    PutScore(out, score);
    if (ReadsTraits()) PutTraits(out, score.traits);
  }
  SaveState(out);
  curve_.Save(out);
}

bool TakeBatchHead(BitReader& in, BatchHead& head, int budget, std::size_t genes, bool traits) {
  if (!TakeCount(in, head.evaluations, budget)) return false;
  if (!TakeGenome(in, head.best, head.best_fitness, genes)) return false;
  if ((head.evaluations > 0) == head.best.empty()) return false;
  int scored = 0;
  if (!TakeCount(in, scored, head.evaluations)) return false;
  head.scores.clear();
  for (int i = 0; i < scored && !in.Overrun(); ++i) {
    head.scores.push_back(TakeScore(in));
    if (traits) TakeBits(in, head.scores.back().traits);
    if (!(head.scores.back().fitness < std::numeric_limits<float>::infinity())) return false;
  }
  return true;
}

bool BatchSearch::Read(BitReader& in) {
  if (!TakeBatchHead(in, head_, settings_.evaluations, space_.shape.Genes(), ReadsTraits())) return false;
  batch_.clear();
  if (!LoadState(in)) return false;
  curve_.Load(in);
  if (in.Overrun() || head_.scores.empty()) return true;
  batch_ = Propose();
  return head_.scores.size() < batch_.size();
}

Result<void> BatchSearch::Load(BitReader& in) {
  BitWriter before;
  Save(before);
  const bool good = Read(in);
  if (good && !in.Overrun() && in.AtEnd()) return {};
  const Result<void> fault =
      in.Overrun() ? Fail(ErrorCode::kTruncated, "search", "the saved search ends too early")
      : good       ? Fail(ErrorCode::kTrailing, "search", "the saved search has data after its end")
                   : Fail(ErrorCode::kOutOfRange, "search", "is not a state of this search");
  // A refused state changes nothing: restore the state from before.
  BitReader back(before.Bytes());
  static_cast<void>(Read(back));
  return fault;
}

std::vector<float> FitnessOf(const std::vector<Individual>& population) {
  std::vector<float> fitness;
  fitness.reserve(population.size());
  for (const Individual& one : population) fitness.push_back(one.fitness);
  return fitness;
}

void PutPopulation(BitWriter& out, const std::vector<Individual>& population) {
  out.Put(population.size(), 32);
  for (const Individual& one : population) PutGenome(out, one.genome, one.fitness);
}

bool TakePopulation(BitReader& in, std::vector<Individual>& population, std::size_t most, std::size_t genes) {
  population.clear();
  const auto size = static_cast<std::size_t>(in.Take(32));
  if (size > most) return false;
  for (std::size_t i = 0; i < size; ++i) {
    Individual one;
    if (!TakeGenome(in, one.genome, one.fitness, genes) || one.genome.size() != genes) return false;
    population.push_back(std::move(one));
  }
  return true;
}

void PutTraits(BitWriter& out, const Traits& traits) {
  for (const float value : traits) out.Put(std::bit_cast<std::uint32_t>(value), 32);
}

bool TakeTraits(BitReader& in, Traits& traits) {
  TakeBits(in, traits);
  return std::ranges::all_of(traits, [](float value) { return value - value == 0.0f; });
}

void PutReal(BitWriter& out, double value) { out.Put(std::bit_cast<std::uint64_t>(value), 64); }

bool TakeReal(BitReader& in, double& value) {
  value = std::bit_cast<double>(in.Take(64));
  return value - value == 0.0;
}

bool TakeCount(BitReader& in, int& count, int most) {
  const std::uint64_t wide = in.Take(32);
  if (wide > static_cast<std::uint64_t>(most)) return false;
  count = static_cast<int>(wide);
  return true;
}

}  // namespace gaitsmith
