// SPDX-License-Identifier: MIT
#include "core/search/cma_run.h"

namespace gaitsmith {

namespace {

constexpr double kMinSpread = 0.5 / kGeneMax;  // half a grid step: all samples would be one genome
constexpr double kMaxSpread = 10.0;            // ten times the cube: all samples would be its corners

}  // namespace

CmaRun::CmaRun(Genome origin, const ControllerShape& shape, const CmaSettings& settings, int population,
               double step)
    : origin_(std::move(origin)) {
  std::vector<bool> ignored(origin_.size());
  if (settings.genes == CmaGenes::kCared) {
    shape.ForEachInterval(
        [&](std::size_t low) { ignored[low] = ignored[low + 1] = !Cares(origin_[low], origin_[low + 1]); });
  }
  for (std::size_t gene = 0; gene < origin_.size(); ++gene) {
    if (!ignored[gene]) free_.push_back(gene);
  }
  const bool full =
      settings.covariance == Covariance::kFull ||
      (settings.covariance == Covariance::kAutomatic && free_.size() <= std::size_t{kMaxFullGenes});
  const int usual =
      settings.population > 0 ? settings.population : CmaDistribution::UsualPopulation(free_.size());
  distribution_ = {FreePointOf(origin_), step, std::max(population, usual), full};
}

std::vector<double> CmaRun::FreePointOf(const Genome& genome) const {
  std::vector<double> point;
  point.reserve(free_.size());
  for (const std::size_t gene : free_) point.push_back(genome[gene] * (1.0 / kGeneMax));
  return point;
}

Genome CmaRun::Sample(const ControllerShape& shape, RandomStream& random) const {
  std::vector<double> point = PointOf(origin_);
  const std::vector<double> sample = distribution_.Sample(random);
  for (std::size_t i = 0; i < free_.size(); ++i) point[free_[i]] = sample[i];
  return GenomeAt(point, shape);
}

void CmaRun::Learn(std::span<const Genome> batch, std::span<const std::size_t> order, int age) {
  std::vector<std::vector<double>> ranked;
  ranked.reserve(order.size());
  for (const std::size_t i : order) ranked.push_back(FreePointOf(batch[i]));
  distribution_.Adapt(ranked, age);
}

bool CmaRun::Over(int stale) const {
  const double widest = distribution_.Spread();
  // Number of generations without improvement that are allowed [Hansen 2016]: 10 + 30 n / lambda.
  const double patience = 10.0 + 30.0 * static_cast<double>(free_.size()) / Population();
  return !distribution_.Sound() || !(widest > kMinSpread && widest < kMaxSpread) || stale > patience;
}

}  // namespace gaitsmith
