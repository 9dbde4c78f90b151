// SPDX-License-Identifier: MIT
#include "core/evolution/cma_mae.h"

#include <algorithm>

namespace gaitsmith {

namespace {

/// Of the random numbers that choose where emitters begin: individuals that no batch has.
constexpr int kBeginnings = 1 << 30;
constexpr float kNoImprovement = -std::numeric_limits<float>::infinity();

}  // namespace

CmaMae::CmaMae(const SearchSettings& settings, const SearchSpace& space)
    : BatchSearch(settings, space), elites_(settings.elites) {}

CmaRun CmaMae::RunFrom(Genome origin) const {
  const CmaSettings& cma = Settings().cma;
  return {std::move(origin), Space().shape, cma, 0, static_cast<double>(cma.step)};
}

CmaMae::Emitter CmaMae::Begin(int at) const {
  RandomStream random = Stream(kBeginnings + at, generation_);
  const std::vector<std::size_t> filled = elites_.Filled();
  if (filled.empty()) {
    return {.run = RunFrom(RandomGenome(Space().shape, Space().senses, Settings().variation, random))};
  }
  return {.run = RunFrom(Cells()[filled[random.Below(static_cast<std::uint32_t>(filled.size()))]].genome)};
}

std::vector<Genome> CmaMae::Propose() const {
  std::vector<Genome> batch;
  if (generation_ == 0) {
    for (int i = 0; i < Settings().elites.initial; ++i) batch.push_back(First(i));
    return batch;
  }
  for (const Emitter& emitter : emitters_) {
    for (int k = 0; k < emitter.run.Population(); ++k) {
      RandomStream random = Stream(static_cast<int>(batch.size()), generation_);
      batch.push_back(emitter.run.Sample(Space().shape, random));
    }
  }
  return batch;
}

float CmaMae::Improve(const Genome& genome, const Score& score) {
  const std::size_t cell = elites_.CellOf(score);
  if (cell == asked_.size()) return kNoImprovement;
  elites_.Add(genome, score);
  const float improvement = score.fitness - asked_[cell];
  if (improvement > 0.0f) asked_[cell] += Settings().elites.learning * improvement;
  return improvement;
}

void CmaMae::AbsorbRest(std::span<const Genome> batch, std::span<const Score> scores) {
  for (std::size_t i = 0; i < batch.size(); ++i) elites_.Add(batch[i], scores[i]);
}

void CmaMae::Absorb(std::span<const Genome> batch, std::span<const Score> scores) {
  if (generation_ == 0) {
    float least = std::numeric_limits<float>::infinity();
    for (const Score& score : scores) {
      if (elites_.CellOf(score) < Cells().size()) least = std::min(least, score.fitness);
    }
    AbsorbRest(batch, scores);
    asked_.assign(Cells().size(), least < std::numeric_limits<float>::infinity() ? least : 0.0f);
    for (int at = 0; at < Settings().elites.emitters; ++at) emitters_.push_back(Begin(at));
    ++generation_;
    return;
  }
  std::vector<float> improvements;
  improvements.reserve(batch.size());
  for (std::size_t i = 0; i < batch.size(); ++i) improvements.push_back(Improve(batch[i], scores[i]));
  ++generation_;
  std::size_t begin = 0;
  for (std::size_t at = 0; at < emitters_.size(); ++at) {
    Emitter& emitter = emitters_[at];
    const auto size = static_cast<std::size_t>(emitter.run.Population());
    const std::span<const float> own = std::span(improvements).subspan(begin, size);
    const std::vector<std::size_t> order = BestFirst(size, [&](std::size_t i) { return own[i]; });
    emitter.run.Learn(batch.subspan(begin, size), order, ++emitter.age);
    emitter.stale = own[order[0]] > 0.0f ? 0 : emitter.stale + 1;
    if (emitter.run.Over(emitter.stale)) emitter = Begin(static_cast<int>(at));
    begin += size;
  }
}

void CmaMae::SaveState(BitWriter& out) const {
  out.Put(static_cast<std::uint32_t>(generation_), 32);
  elites_.Save(out);
  for (const float asked : asked_) out.Put(std::bit_cast<std::uint32_t>(asked), 32);
  for (const Emitter& emitter : emitters_) {
    PutGenome(out, emitter.run.Origin(), 0.0f);
    out.Put(static_cast<std::uint32_t>(emitter.age), 32);
    out.Put(static_cast<std::uint32_t>(emitter.stale), 32);
    emitter.run.Save(out);
  }
}

bool CmaMae::LoadState(BitReader& in) {
  const std::size_t genes = Space().shape.Genes();
  asked_.clear();
  emitters_.clear();
  if (!TakeCount(in, generation_, Settings().evaluations) || !elites_.Load(in, genes)) return false;
  if (generation_ == 0) return true;
  asked_.resize(Cells().size());
  for (float& asked : asked_) {
    asked = std::bit_cast<float>(static_cast<std::uint32_t>(in.Take(32)));
    if (!(asked - asked == 0.0f)) return false;
  }
  for (int at = 0; at < Settings().elites.emitters && !in.Overrun(); ++at) {
    Genome origin;
    float zero = 0.0f;
    Emitter emitter;
    if (!TakeGenome(in, origin, zero, genes) || origin.empty() || std::bit_cast<std::uint32_t>(zero) != 0)
      return false;
    if (!TakeCount(in, emitter.age, Settings().evaluations)) return false;
    if (!TakeCount(in, emitter.stale, Settings().evaluations)) return false;
    emitter.run = RunFrom(std::move(origin));
    if (!emitter.run.Load(in)) return false;
    emitters_.push_back(std::move(emitter));
  }
  return true;
}

std::unique_ptr<Search> MakeCmaMae(const SearchSettings& settings, const SearchSpace& space) {
  return std::make_unique<CmaMae>(settings, space);
}

}  // namespace gaitsmith
