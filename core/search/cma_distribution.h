// SPDX-License-Identifier: MIT
// The normal distribution that covariance matrix adaptation learns [Hansen 2016], in full or with variances
// only [Ros Hansen 2008]:
//
//   x_k = m + sigma A z_k,   A A^T = C,   z_k normal
//
// A is the Cholesky factor, as in [Krause 2016], not the symmetric root. Its few loops sum in the same order
// everywhere. An eigensolver with cache-dependent blocks would not.
#pragma once

#include <span>
#include <vector>

#include "core/numeric/bit_stream.h"
#include "core/numeric/random.h"

namespace gaitsmith {

class CmaDistribution {
 public:
  CmaDistribution() = default;
  /// @param mean       one number for each dimension, at least one
  /// @param sigma      step size, > 0
  /// @param population lambda, the number of samples in a generation, >= 4
  /// @param full       with covariances; otherwise with variances only
  CmaDistribution(std::vector<double> mean, double sigma, int population, bool full);

  /// The usual lambda: 4 + 3 ln n [Hansen 2016]. @param dimensions n, at least 1
  [[nodiscard]] static int UsualPopulation(std::size_t dimensions);

  [[nodiscard]] int Population() const { return population_; }
  [[nodiscard]] std::size_t Dimensions() const { return n_; }
  /// One sample.
  [[nodiscard]] std::vector<double> Sample(RandomStream& random) const;

  /// Learns from one generation.
  /// @param ranked points that were scored, best first; at least the better half of the population. They may
  ///               differ from the samples, by clamping or rounding
  /// @param age    generations of this distribution so far, from 1
  void Adapt(std::span<const std::vector<double>> ranked, int age);

  /// The greatest standard deviation of a coordinate.
  [[nodiscard]] double Spread() const;
  /// False once the covariance is no longer positive definite. It can then not be sampled.
  [[nodiscard]] bool Sound() const { return sound_; }

  void Save(BitWriter&) const;
  /// Into a distribution of the same dimensions and population. @return false if this cannot be a state
  [[nodiscard]] bool Load(BitReader&);

 private:
  /// Constants derived from the dimension and the population.
  struct Rates {
    std::vector<double> weights;  // weights of the better half, best first, sum 1
    double mass;                  // mu_eff, the variance-effective size of the better half
    double c_sigma, damping, c_path, c_one, c_mu;
    double expected_length;  // expected length of a standard normal vector
  };
  [[nodiscard]] Rates RatesFor(int population) const;
  /// Index into the lower triangle of the covariance or its factor, or into the diagonal if separable.
  [[nodiscard]] std::size_t At(std::size_t row, std::size_t column) const {
    return full_ ? row * (row + 1) / 2 + column : row;
  }
  void Factorise();

  std::size_t n_ = 0;
  bool full_ = true;
  bool sound_ = true;
  int population_ = 0;
  Rates rates_{};
  std::vector<double> covariance_;  // lower triangle, row after row, or the diagonal
  std::vector<double> factor_;      // in the same layout; computed from the covariance
  std::vector<double> mean_, path_, sigma_path_;
  double sigma_ = 0.0;
};

}  // namespace gaitsmith
