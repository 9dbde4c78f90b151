// SPDX-License-Identifier: MIT
// Covariance matrix adaptation evolution strategy (CMA-ES) [Hansen 2016] over the unit cube of genes, in full
// or with variances only [Ros Hansen 2008], restarted with a larger population when it stalls
// [Auger Hansen 2005].
//
//   x_k = m + sigma A z_k,   A A^T = C,   z_k normal
//
// A is the Cholesky factor, as in [Krause 2016], not the symmetric root: its few loops sum in one fixed order
// everywhere, which an eigensolver with cache-dependent blocks would not. Samples are moved to the nearest
// genome before they count, so the distribution learns from what was simulated. A run begins with the
// evaluation of its mean: the given start in the first run, random genomes in others.
#pragma once

#include "core/search/batch_search.h"

namespace gaitsmith {

class CmaEs final : public BatchSearch {
 public:
  CmaEs(const SearchSettings& settings, const SearchSpace& space);

 private:
  /// Constants that follow from dimension and population.
  struct Rules {
    std::vector<double> weights;  // of the better half, best first, sum 1
    double mass;                  // mu_eff, its variance-effective size
    double c_sigma, damping, c_path, c_one, c_mu;
    double expected_length;  // of a standard normal vector
  };

  [[nodiscard]] std::vector<Genome> Propose() const override;
  void Absorb(std::span<const Genome> batch, std::span<const Score> scores) override;
  void SaveState(BitWriter&) const override;
  [[nodiscard]] bool LoadState(BitReader&) override;

  [[nodiscard]] Rules RulesFor(int population) const;
  [[nodiscard]] int FirstPopulation() const;
  void BeginRun(int population);
  void Adapt(std::span<const Genome> batch, std::span<const Score> scores);
  [[nodiscard]] bool Stalled() const;
  /// Row of the lower triangle of the covariance or its factor; the separable one has the diagonal alone.
  [[nodiscard]] std::size_t At(std::size_t row, std::size_t column) const;
  /// @return false when the covariance is not positive definite any more
  [[nodiscard]] bool Factorise();

  std::size_t genes_;
  bool full_;
  Rules rules_;
  std::vector<double> covariance_;  // lower triangle, row after row, or the diagonal
  std::vector<double> factor_;      // likewise; follows from the covariance
  std::vector<double> mean_, path_, sigma_path_;
  double sigma_ = 0.0;
  int population_ = 0;
  int run_ = 0;
  int age_ = 0;         // generations of this run; 0: its mean is to be evaluated
  int generation_ = 1;  // of all runs, for the random numbers
  int stale_ = 0;       // generations without a better one
  float run_best_ = 0.0f;
};

}  // namespace gaitsmith
