// SPDX-License-Identifier: MIT
#include "core/search/cma_es.h"

#include <algorithm>

#include "core/numeric/scalar_math.h"

namespace gaitsmith {

namespace {

constexpr int kMaxPopulation = 10000;
constexpr double kLog10 = 2.302585092994046;
/// Of the random numbers that choose how a small run begins. No generation has this number.
constexpr std::uint64_t kRestartStream = 0xffffffff;

}  // namespace

CmaEs::CmaEs(const SearchSettings& settings, const SearchSpace& space) : BatchSearch(settings, space) {}

int CmaEs::Draws() const { return runs_ == 0 && !Space().start.empty() ? 1 : Settings().cma.draws; }

void CmaEs::BeginAt(const Genome& origin) {
  const CmaSettings& cma = Settings().cma;
  auto step = static_cast<double>(cma.step);
  int population = population_;
  if (small_) {
    RandomStream random(Settings().seed, static_cast<std::uint64_t>(runs_), kRestartStream);
    const double usual = CmaRun(origin, Space().shape, cma, 0, step).Population();
    const double u = random.Uniform();
    population = static_cast<int>(usual * Exp(u * u * Log(std::max(1.0, large_ / (2.0 * usual)))));
    step *= Exp(-2.0 * kLog10 * random.Uniform());
  }
  run_ = {origin, Space().shape, cma, population, step};
  population_ = run_.Population();
}

std::vector<Genome> CmaEs::Propose() const {
  std::vector<Genome> batch;
  if (!run_.Begun()) {
    // A given start is individual 0 of the first run.
    for (int k = 0; k < Draws(); ++k) batch.push_back(First(runs_ * Settings().cma.draws + k));
    return batch;
  }
  batch.reserve(static_cast<std::size_t>(population_));
  for (int k = 0; k < population_; ++k) {
    RandomStream random = Stream(k, generation_);
    batch.push_back(run_.Sample(Space().shape, random));
  }
  return batch;
}

void CmaEs::EndRun() {
  ++runs_;
  run_ = {};
  age_ = 0;
  stale_ = 0;
  if (Bipop()) {
    if (!small_) large_ = population_;
    // The first run is a large one, and so is the second: a small run needs a large one to be smaller than.
    small_ = runs_ > 1 && spent_[1] < spent_[0];
    if (small_) return;
    population_ = large_;
  }
  const double grown = population_ * static_cast<double>(Settings().cma.growth);
  population_ = static_cast<int>(std::min<double>(grown, kMaxPopulation));
}

void CmaEs::Absorb(std::span<const Genome> batch, std::span<const Score> scores) {
  last_fitness_.clear();
  for (const Score& score : scores) last_fitness_.push_back(score.fitness);
  spent_[small_ ? 1 : 0] += static_cast<int>(batch.size());
  if (!run_.Begun()) {
    const auto best = std::ranges::max_element(scores, {}, &Score::fitness);
    run_best_ = best->fitness;
    BeginAt(batch[static_cast<std::size_t>(best - scores.begin())]);
    age_ = 1;
    return;
  }
  const std::vector<std::size_t> order =
      BestFirst(batch.size(), [&](std::size_t i) { return scores[i].fitness; });
  run_.Learn(batch, order, age_);
  const float best = scores[order[0]].fitness;
  const bool better = best > run_best_;
  stale_ = better ? 0 : stale_ + 1;
  if (better) run_best_ = best;
  ++age_;
  ++generation_;
  if (run_.Over(stale_)) EndRun();
}

void CmaEs::SaveState(BitWriter& out) const {
  for (const int count : {runs_, age_, generation_, stale_, population_}) {
    out.Put(static_cast<std::uint32_t>(count), 32);
  }
  if (Bipop()) {
    out.Put(small_ ? 1 : 0, 1);
    for (const int count : {large_, spent_[0], spent_[1]}) out.Put(static_cast<std::uint32_t>(count), 32);
  }
  PutGenome(out, run_.Origin(), run_best_);
  if (run_.Begun()) run_.Save(out);
}

bool CmaEs::LoadState(BitReader& in) {
  for (int* count : {&runs_, &age_, &generation_, &stale_}) {
    if (!TakeCount(in, *count, Settings().evaluations + 1)) return false;
  }
  if (!TakeCount(in, population_, kMaxPopulation)) return false;
  if (Bipop()) {
    small_ = in.Take(1) != 0;
    if (!TakeCount(in, large_, kMaxPopulation)) return false;
    for (int& spent : spent_) {
      if (!TakeCount(in, spent, Settings().evaluations)) return false;
    }
    if (small_ && large_ == 0) return false;
  }
  Genome origin;
  if (!TakeGenome(in, origin, run_best_, Space().shape.Genes())) return false;
  if (generation_ < 1 || (age_ > 0) == origin.empty()) return false;
  run_ = {};
  if (origin.empty()) return true;
  const int population = population_;
  run_ = {std::move(origin), Space().shape, Settings().cma, population, 1.0};
  return run_.Population() == population && run_.Load(in);
}

std::unique_ptr<Search> MakeCmaEs(const SearchSettings& settings, const SearchSpace& space) {
  return std::make_unique<CmaEs>(settings, space);
}

}  // namespace gaitsmith
