// SPDX-License-Identifier: MIT
#include "core/search/cma_distribution.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/scalar_math.h"
#include "core/search/batch_search.h"

namespace gaitsmith {

namespace {

double Square(double x) { return x * x; }

}  // namespace

CmaDistribution::CmaDistribution(std::vector<double> mean, double sigma, int population, bool full)
    : n_(mean.size()), full_(full), population_(population), mean_(std::move(mean)), sigma_(sigma) {
  rates_ = RatesFor(population_);
  covariance_.assign(full_ ? n_ * (n_ + 1) / 2 : n_, 0.0);
  for (std::size_t i = 0; i < n_; ++i) covariance_[At(i, i)] = 1.0;
  factor_ = covariance_;
  path_.assign(n_, 0.0);
  sigma_path_.assign(n_, 0.0);
}

int CmaDistribution::UsualPopulation(std::size_t dimensions) {
  return 4 + static_cast<int>(3.0 * Log(static_cast<double>(dimensions)));
}

CmaDistribution::Rates CmaDistribution::RatesFor(int population) const {
  Rates r{};
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
  const auto n = static_cast<double>(n_);
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

void CmaDistribution::Factorise() {
  sound_ = false;
  factor_.assign(covariance_.size(), 0.0);
  for (std::size_t row = 0; row < n_; ++row) {
    for (std::size_t column = full_ ? 0 : row; column <= row; ++column) {
      double rest = covariance_[At(row, column)];
      for (std::size_t k = full_ ? 0 : column; k < column; ++k)
        rest -= factor_[At(row, k)] * factor_[At(column, k)];
      if (column < row) {
        factor_[At(row, column)] = rest / factor_[At(column, column)];
      } else {
        if (!(rest > 0.0)) return;
        factor_[At(row, row)] = std::sqrt(rest);
      }
    }
  }
  sound_ = true;
}

std::vector<double> CmaDistribution::Sample(RandomStream& random) const {
  std::vector<double> normal(n_), point(n_);
  for (double& z : normal) z = random.Normal();
  for (std::size_t row = 0; row < n_; ++row) {
    double sum = 0.0;
    for (std::size_t column = full_ ? 0 : row; column <= row; ++column) {
      sum += factor_[At(row, column)] * normal[column];
    }
    point[row] = mean_[row] + sigma_ * sum;
  }
  return point;
}

void CmaDistribution::Adapt(std::span<const std::vector<double>> ranked, int age) {
  const Rates& r = rates_;
  const std::size_t parents = r.weights.size();

  // Steps of the better half in units of sigma, and their weighted mean.
  std::vector<std::vector<double>> steps(parents);
  std::vector<double> mean_step(n_, 0.0);
  for (std::size_t i = 0; i < parents; ++i) {
    steps[i] = ranked[i];
    for (std::size_t k = 0; k < n_; ++k) {
      steps[i][k] = (steps[i][k] - mean_[k]) / sigma_;
      mean_step[k] += r.weights[i] * steps[i][k];
    }
  }
  for (std::size_t k = 0; k < n_; ++k) mean_[k] += sigma_ * mean_step[k];

  // The path of steps in the coordinates of the samples: solve A w = mean step.
  std::vector<double> whitened = mean_step;
  double length = 0.0;
  const double keep = std::sqrt(r.c_sigma * (2.0 - r.c_sigma) * r.mass);
  for (std::size_t row = 0; row < n_; ++row) {
    for (std::size_t k = full_ ? 0 : row; k < row; ++k) whitened[row] -= factor_[At(row, k)] * whitened[k];
    whitened[row] /= factor_[At(row, row)];
    sigma_path_[row] = (1.0 - r.c_sigma) * sigma_path_[row] + keep * whitened[row];
    length += Square(sigma_path_[row]);
  }
  length = std::sqrt(length);
  const double settled = std::sqrt(1.0 - Exp(2.0 * age * Log(1.0 - r.c_sigma)));
  const auto n = static_cast<double>(n_);
  const bool steady = length / settled < (1.4 + 2.0 / (n + 1.0)) * r.expected_length;

  const double along = steady ? std::sqrt(r.c_path * (2.0 - r.c_path) * r.mass) : 0.0;
  for (std::size_t k = 0; k < n_; ++k) path_[k] = (1.0 - r.c_path) * path_[k] + along * mean_step[k];
  const double old = 1.0 - r.c_one - r.c_mu + (steady ? 0.0 : r.c_one * r.c_path * (2.0 - r.c_path));
  for (std::size_t row = 0; row < n_; ++row) {
    for (std::size_t column = full_ ? 0 : row; column <= row; ++column) {
      double spread = 0.0;
      for (std::size_t i = 0; i < parents; ++i) spread += r.weights[i] * steps[i][row] * steps[i][column];
      double& c = covariance_[At(row, column)];
      c = old * c + r.c_one * path_[row] * path_[column] + r.c_mu * spread;
    }
  }
  sigma_ *= Exp(std::min(1.0, r.c_sigma / r.damping * (length / r.expected_length - 1.0)));
  Factorise();
}

double CmaDistribution::Spread() const {
  double widest = 0.0;
  for (std::size_t k = 0; k < n_; ++k) widest = std::max(widest, sigma_ * std::sqrt(covariance_[At(k, k)]));
  return widest;
}

void CmaDistribution::Save(BitWriter& out) const {
  PutReal(out, sigma_);
  for (const auto* list : {&mean_, &path_, &sigma_path_, &covariance_}) {
    for (const double value : *list) PutReal(out, value);
  }
}

bool CmaDistribution::Load(BitReader& in) {
  if (!TakeReal(in, sigma_)) return false;
  for (auto* list : {&mean_, &path_, &sigma_path_, &covariance_}) {
    for (double& value : *list) {
      if (!TakeReal(in, value)) return false;
    }
  }
  if (in.Overrun()) return true;  // the caller reports the error
  Factorise();
  return sigma_ > 0.0 && sound_;
}

}  // namespace gaitsmith
