// SPDX-License-Identifier: MIT
#include "core/search/random_search.h"

#include <algorithm>
#include <limits>

#include "core/control/genome_bits.h"

namespace gaitsmith {

RandomSearch::RandomSearch(const SearchSettings& settings, const SearchSpace& space)
    : settings_(settings), space_(space), best_fitness_(-std::numeric_limits<float>::infinity()) {}

Genome RandomSearch::Draw(int evaluation) const {
  if (evaluation == 0) return FirstGenome(space_, settings_.variation, settings_.seed, 0);
  RandomStream random(settings_.seed, 0, static_cast<std::uint64_t>(evaluation));
  return RandomGenome(space_.shape, space_.senses, settings_.variation, random);
}

std::vector<Genome> RandomSearch::Ask(int wanted) {
  std::vector<Genome> asked;
  const int count = std::clamp(wanted, 0, settings_.evaluations - evaluations_);
  asked.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) asked.push_back(Draw(evaluations_ + i));
  return asked;
}

void RandomSearch::Tell(std::span<const Score> scores) {
  for (const Score& score : scores) {
    const float value = score.fitness;
    if (value > best_fitness_ || best_.empty()) {
      best_ = Draw(evaluations_);
      if (value > best_fitness_) best_fitness_ = value;
      curve_.Add(evaluations_ + 1, best_fitness_);
    }
    ++evaluations_;
  }
  curve_.SettleTo(evaluations_);
}

void RandomSearch::Save(BitWriter& out) const {
  out.Put(static_cast<std::uint32_t>(evaluations_), 32);
  PutGenome(out, best_, best_fitness_);
  curve_.Save(out);
}

Result<void> RandomSearch::Load(BitReader& in) {
  RandomSearch read(settings_, space_);
  const auto evaluations = static_cast<std::int64_t>(in.Take(32));
  const bool good = TakeGenome(in, read.best_, read.best_fitness_, space_.shape.Genes());
  read.curve_.Load(in);
  if (in.Overrun()) return Fail(ErrorCode::kTruncated, "search", "the saved search ends too early");
  if (!in.AtEnd()) return Fail(ErrorCode::kTrailing, "search", "the saved search has data after its end");
  if (!good || evaluations > settings_.evaluations || (evaluations > 0) == read.best_.empty()) {
    return Fail(ErrorCode::kOutOfRange, "search", "is not a state of this search");
  }
  read.evaluations_ = static_cast<int>(evaluations);
  *this = std::move(read);
  return {};
}

std::unique_ptr<Search> MakeRandomSearch(const SearchSettings& settings, const SearchSpace& space) {
  return std::make_unique<RandomSearch>(settings, space);
}

}  // namespace gaitsmith
