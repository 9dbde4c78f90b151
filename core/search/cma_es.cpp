// SPDX-License-Identifier: MIT
#include "core/search/cma_es.h"

#include <algorithm>
#include <numeric>

namespace gaitsmith {

namespace {

constexpr int kMaxPopulation = 10000;
constexpr double kMinSpread = 0.5 / kGeneMax;  // half a grid step: all samples would be one genome
constexpr double kMaxSpread = 10.0;            // ten times the cube: all samples would be its corners

}  // namespace

CmaEs::CmaEs(const SearchSettings& settings, const SearchSpace& space) : BatchSearch(settings, space) {}

int CmaEs::Draws() const { return run_ == 0 && !Space().start.empty() ? 1 : Settings().cma.draws; }

int CmaEs::FirstPopulation() const {
  if (Settings().cma.population > 0) return Settings().cma.population;
  return CmaDistribution::UsualPopulation(free_.size());
}

void CmaEs::BeginAt(const Genome& origin, int population) {
  std::vector<bool> ignored(origin.size());
  if (Settings().cma.genes == CmaGenes::kCared) {
    Space().shape.ForEachInterval(
        [&](std::size_t low) { ignored[low] = ignored[low + 1] = !Cares(origin[low], origin[low + 1]); });
  }
  free_.clear();
  for (std::size_t gene = 0; gene < origin.size(); ++gene) {
    if (!ignored[gene]) free_.push_back(gene);
  }
  const Covariance kind = Settings().cma.covariance;
  const bool full = kind == Covariance::kFull ||
                    (kind == Covariance::kAutomatic && free_.size() <= std::size_t{kMaxFullGenes});
  origin_ = origin;
  population_ = std::max(population, FirstPopulation());
  distribution_ = {FreePointOf(origin), static_cast<double>(Settings().cma.step), population_, full};
}

std::vector<double> CmaEs::FreePointOf(const Genome& genome) const {
  std::vector<double> point;
  point.reserve(free_.size());
  for (const std::size_t gene : free_) point.push_back(genome[gene] * (1.0 / kGeneMax));
  return point;
}

std::vector<Genome> CmaEs::Propose() const {
  std::vector<Genome> batch;
  if (origin_.empty()) {
    // A given start is individual 0 of the first run.
    for (int k = 0; k < Draws(); ++k) batch.push_back(First(run_ * Settings().cma.draws + k));
    return batch;
  }
  batch.reserve(static_cast<std::size_t>(population_));
  std::vector<double> point = PointOf(origin_);
  for (int k = 0; k < population_; ++k) {
    RandomStream random = Stream(k, generation_);
    const std::vector<double> sample = distribution_.Sample(random);
    for (std::size_t i = 0; i < free_.size(); ++i) point[free_[i]] = sample[i];
    batch.push_back(GenomeAt(point, Space().shape));
  }
  return batch;
}

void CmaEs::Adapt(std::span<const Genome> batch, std::span<const Score> scores) {
  std::vector<std::size_t> order(batch.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    return scores[a].fitness != scores[b].fitness ? scores[a].fitness > scores[b].fitness : a < b;
  });
  std::vector<std::vector<double>> ranked;
  ranked.reserve(order.size());
  for (const std::size_t i : order) ranked.push_back(FreePointOf(batch[i]));
  distribution_.Adapt(ranked, age_);

  const float best = scores[order[0]].fitness;
  const bool better = best > run_best_;
  stale_ = better ? 0 : stale_ + 1;
  if (better) run_best_ = best;
}

bool CmaEs::Stalled() const {
  const double widest = distribution_.Spread();
  // Number of generations without improvement that are allowed [Hansen 2016]: 10 + 30 n / lambda.
  const double patience = 10.0 + 30.0 * static_cast<double>(free_.size()) / population_;
  return !(widest > kMinSpread && widest < kMaxSpread) || stale_ > patience;
}

void CmaEs::Absorb(std::span<const Genome> batch, std::span<const Score> scores) {
  last_fitness_.clear();
  for (const Score& score : scores) last_fitness_.push_back(score.fitness);
  if (origin_.empty()) {
    const auto best = std::ranges::max_element(scores, {}, &Score::fitness);
    run_best_ = best->fitness;
    BeginAt(batch[static_cast<std::size_t>(best - scores.begin())], population_);
    age_ = 1;
    return;
  }
  Adapt(batch, scores);
  ++age_;
  ++generation_;
  if (distribution_.Sound() && !Stalled()) return;
  ++run_;
  const double grown = population_ * static_cast<double>(Settings().cma.growth);
  population_ = static_cast<int>(std::min<double>(grown, kMaxPopulation));
  origin_.clear();
  age_ = 0;
  stale_ = 0;
}

void CmaEs::SaveState(BitWriter& out) const {
  for (const int count : {run_, age_, generation_, stale_, population_}) {
    out.Put(static_cast<std::uint32_t>(count), 32);
  }
  PutGenome(out, origin_, run_best_);
  if (origin_.empty()) return;
  distribution_.Save(out);
}

bool CmaEs::LoadState(BitReader& in) {
  for (int* count : {&run_, &age_, &generation_, &stale_}) {
    if (!TakeCount(in, *count, Settings().evaluations + 1)) return false;
  }
  if (!TakeCount(in, population_, kMaxPopulation)) return false;
  Genome origin;
  if (!TakeGenome(in, origin, run_best_, Space().shape.Genes())) return false;
  if (generation_ < 1 || (age_ > 0) == origin.empty()) return false;
  origin_.clear();
  if (origin.empty()) return true;
  const int population = population_;
  BeginAt(origin, population);
  return population_ == population && distribution_.Load(in);
}

std::unique_ptr<Search> MakeCmaEs(const SearchSettings& settings, const SearchSpace& space) {
  return std::make_unique<CmaEs>(settings, space);
}

}  // namespace gaitsmith
