// SPDX-License-Identifier: MIT
#include "core/search/cma_es.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/numeric/scalar_math.h"

namespace gaitsmith {

namespace {

constexpr int kMaxPopulation = 10000;
constexpr double kMinSpread = 0.5 / kGeneMax;  // half a grid step: all samples would be one genome
constexpr double kMaxSpread = 10.0;            // ten times the cube: all samples would be its corners

double Square(double x) { return x * x; }

}  // namespace

CmaEs::CmaEs(const SearchSettings& settings, const SearchSpace& space) : BatchSearch(settings, space) {}

int CmaEs::Draws() const { return run_ == 0 && !Space().start.empty() ? 1 : Settings().cma.draws; }

int CmaEs::FirstPopulation() const {
  if (Settings().cma.population > 0) return Settings().cma.population;
  return 4 + static_cast<int>(3.0 * Log(static_cast<double>(genes_)));
}

CmaEs::Rules CmaEs::RulesFor(int population) const {
  Rules r{};
  const int parents = population / 2;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 1; i <= parents; ++i) {
    r.weights.push_back(Log(0.5 * (population + 1)) - Log(i));
    sum += r.weights.back();
  }
  for (double& weight : r.weights) {
    weight /= sum;
    squares += Square(weight);
  }
  r.mass = 1.0 / squares;
  const auto n = static_cast<double>(genes_);
  r.c_sigma = (r.mass + 2.0) / (n + r.mass + 5.0);
  r.damping = 1.0 + 2.0 * std::max(0.0, std::sqrt((r.mass - 1.0) / (n + 1.0)) - 1.0) + r.c_sigma;
  r.c_path = (4.0 + r.mass / n) / (n + 4.0 + 2.0 * r.mass / n);
  r.c_one = 2.0 / (Square(n + 1.3) + r.mass);
  r.c_mu = 2.0 * (r.mass - 2.0 + 1.0 / r.mass) / (Square(n + 2.0) + r.mass);
  if (!full_) {
    // n variances can be learnt faster than n^2 / 2 covariances [Ros Hansen 2008].
    r.c_one *= (n + 2.0) / 3.0;
    r.c_mu *= (n + 2.0) / 3.0;
  }
  r.c_one = std::min(r.c_one, 1.0);
  r.c_mu = std::min(r.c_mu, 1.0 - r.c_one);
  r.expected_length = std::sqrt(n) * (1.0 - 1.0 / (4.0 * n) + 1.0 / (21.0 * n * n));
  return r;
}

std::size_t CmaEs::At(std::size_t row, std::size_t column) const {
  return full_ ? row * (row + 1) / 2 + column : row;
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
  genes_ = free_.size();
  const Covariance kind = Settings().cma.covariance;
  full_ =
      kind == Covariance::kFull || (kind == Covariance::kAutomatic && genes_ <= std::size_t{kMaxFullGenes});
  origin_ = origin;
  population_ = std::max(population, FirstPopulation());
  rules_ = RulesFor(population_);
  covariance_.assign(full_ ? genes_ * (genes_ + 1) / 2 : genes_, 0.0);
  for (std::size_t gene = 0; gene < genes_; ++gene) covariance_[At(gene, gene)] = 1.0;
  factor_ = covariance_;
  path_.assign(genes_, 0.0);
  sigma_path_.assign(genes_, 0.0);
  mean_ = FreePointOf(origin);
  sigma_ = static_cast<double>(Settings().cma.step);
}

std::vector<double> CmaEs::FreePointOf(const Genome& genome) const {
  std::vector<double> point;
  point.reserve(genes_);
  for (const std::size_t gene : free_) point.push_back(genome[gene] * (1.0 / kGeneMax));
  return point;
}

bool CmaEs::Factorise() {
  factor_.assign(covariance_.size(), 0.0);
  for (std::size_t row = 0; row < genes_; ++row) {
    for (std::size_t column = full_ ? 0 : row; column <= row; ++column) {
      double rest = covariance_[At(row, column)];
      for (std::size_t k = full_ ? 0 : column; k < column; ++k)
        rest -= factor_[At(row, k)] * factor_[At(column, k)];
      if (column < row) {
        factor_[At(row, column)] = rest / factor_[At(column, column)];
      } else {
        if (!(rest > 0.0)) return false;
        factor_[At(row, row)] = std::sqrt(rest);
      }
    }
  }
  return true;
}

std::vector<Genome> CmaEs::Propose() const {
  std::vector<Genome> batch;
  if (origin_.empty()) {
    // A given start is individual 0 of the first run.
    for (int k = 0; k < Draws(); ++k) batch.push_back(First(run_ * Settings().cma.draws + k));
    return batch;
  }
  batch.reserve(static_cast<std::size_t>(population_));
  std::vector<double> normal(genes_);
  std::vector<double> point = PointOf(origin_);
  for (int k = 0; k < population_; ++k) {
    RandomStream random = Stream(k, generation_);
    for (double& z : normal) z = random.Normal();
    for (std::size_t row = 0; row < genes_; ++row) {
      double sum = 0.0;
      for (std::size_t column = full_ ? 0 : row; column <= row; ++column) {
        sum += factor_[At(row, column)] * normal[column];
      }
      point[free_[row]] = mean_[row] + sigma_ * sum;
    }
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
  const Rules& r = rules_;
  const std::size_t parents = r.weights.size();

  // Steps of the better half in units of sigma, and their weighted mean.
  std::vector<std::vector<double>> steps(parents);
  std::vector<double> mean_step(genes_, 0.0);
  for (std::size_t i = 0; i < parents; ++i) {
    steps[i] = FreePointOf(batch[order[i]]);
    for (std::size_t gene = 0; gene < genes_; ++gene) {
      steps[i][gene] = (steps[i][gene] - mean_[gene]) / sigma_;
      mean_step[gene] += r.weights[i] * steps[i][gene];
    }
  }
  for (std::size_t gene = 0; gene < genes_; ++gene) mean_[gene] += sigma_ * mean_step[gene];

  // The path of steps in the coordinates of the samples: solve A w = mean step.
  std::vector<double> whitened = mean_step;
  double length = 0.0;
  const double keep = std::sqrt(r.c_sigma * (2.0 - r.c_sigma) * r.mass);
  for (std::size_t row = 0; row < genes_; ++row) {
    for (std::size_t k = full_ ? 0 : row; k < row; ++k) whitened[row] -= factor_[At(row, k)] * whitened[k];
    whitened[row] /= factor_[At(row, row)];
    sigma_path_[row] = (1.0 - r.c_sigma) * sigma_path_[row] + keep * whitened[row];
    length += Square(sigma_path_[row]);
  }
  length = std::sqrt(length);
  const double settled = std::sqrt(1.0 - Exp(2.0 * age_ * Log(1.0 - r.c_sigma)));
  const auto n = static_cast<double>(genes_);
  const bool steady = length / settled < (1.4 + 2.0 / (n + 1.0)) * r.expected_length;

  const double along = steady ? std::sqrt(r.c_path * (2.0 - r.c_path) * r.mass) : 0.0;
  for (std::size_t gene = 0; gene < genes_; ++gene) {
    path_[gene] = (1.0 - r.c_path) * path_[gene] + along * mean_step[gene];
  }
  const double old = 1.0 - r.c_one - r.c_mu + (steady ? 0.0 : r.c_one * r.c_path * (2.0 - r.c_path));
  for (std::size_t row = 0; row < genes_; ++row) {
    for (std::size_t column = full_ ? 0 : row; column <= row; ++column) {
      double spread = 0.0;
      for (std::size_t i = 0; i < parents; ++i) spread += r.weights[i] * steps[i][row] * steps[i][column];
      double& c = covariance_[At(row, column)];
      c = old * c + r.c_one * path_[row] * path_[column] + r.c_mu * spread;
    }
  }
  sigma_ *= Exp(std::min(1.0, r.c_sigma / r.damping * (length / r.expected_length - 1.0)));

  const float best = scores[order[0]].fitness;
  const bool better = best > run_best_;
  stale_ = better ? 0 : stale_ + 1;
  if (better) run_best_ = best;
}

bool CmaEs::Stalled() const {
  double widest = 0.0;
  for (std::size_t gene = 0; gene < genes_; ++gene) {
    widest = std::max(widest, sigma_ * std::sqrt(covariance_[At(gene, gene)]));
  }
  // Number of generations without improvement that are allowed [Hansen 2016]: 10 + 30 n / lambda.
  const double patience = 10.0 + 30.0 * static_cast<double>(genes_) / population_;
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
  if (Factorise() && !Stalled()) return;
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
  PutReal(out, sigma_);
  for (const auto* list : {&mean_, &path_, &sigma_path_, &covariance_}) {
    for (const double value : *list) PutReal(out, value);
  }
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
  if (population_ != population || !TakeReal(in, sigma_)) return false;
  for (auto* list : {&mean_, &path_, &sigma_path_, &covariance_}) {
    for (double& value : *list) {
      if (!TakeReal(in, value)) return false;
    }
  }
  if (in.Overrun()) return true;  // the caller reports the error
  return sigma_ > 0.0 && Factorise();
}

std::unique_ptr<Search> MakeCmaEs(const SearchSettings& settings, const SearchSpace& space) {
  return std::make_unique<CmaEs>(settings, space);
}

}  // namespace gaitsmith
