// SPDX-License-Identifier: MIT
// Covariance matrix adaptation evolution strategy (CMA-ES) [Hansen 2016] over the unit cube of genes, in full
// or with variances only [Ros Hansen 2008]. It restarts with a larger population when it stalls
// [Auger Hansen 2005].
//
//   x_k = m + sigma A z_k,   A A^T = C,   z_k normal
//
// A is the Cholesky factor, as in [Krause 2016], not the symmetric root. Its few loops sum in the same order
// everywhere. An eigensolver with cache-dependent blocks would not. Samples are rounded to the nearest genome
// before they are used, so the distribution learns from what was simulated.
//
// A run begins at the best of some random genomes. The first run begins at the given start, if there is one.
// That genome also determines which senses its rules ignore: an interval over the whole range is a switch,
// not a number. Noise on it would make every rule use every sense, so that no rule would ever match.
#pragma once

#include "core/search/batch_search.h"

namespace gaitsmith {

class CmaEs final : public BatchSearch {
 public:
  CmaEs(const SearchSettings& settings, const SearchSpace& space);
  [[nodiscard]] std::vector<float> PopulationFitness() const override { return last_fitness_; }

 private:
  /// Constants derived from the dimension and the population.
  struct Rules {
    std::vector<double> weights;  // weights of the better half, best first, sum 1
    double mass;                  // mu_eff, the variance-effective size of the better half
    double c_sigma, damping, c_path, c_one, c_mu;
    double expected_length;  // expected length of a standard normal vector
  };

  [[nodiscard]] std::vector<Genome> Propose() const override;
  void Absorb(std::span<const Genome> batch, std::span<const Score> scores) override;
  void SaveState(BitWriter&) const override;
  [[nodiscard]] bool LoadState(BitReader&) override;

  [[nodiscard]] Rules RulesFor(int population) const;
  [[nodiscard]] int FirstPopulation() const;
  /// Number of random genomes drawn at the start of this run.
  [[nodiscard]] int Draws() const;
  /// Determines which genes are free, and sets up everything that depends on their number.
  void BeginAt(const Genome& origin, int population);
  [[nodiscard]] std::vector<double> FreePointOf(const Genome&) const;
  void Adapt(std::span<const Genome> batch, std::span<const Score> scores);
  [[nodiscard]] bool Stalled() const;
  /// Index into the lower triangle of the covariance or its factor, or into the diagonal if separable.
  [[nodiscard]] std::size_t At(std::size_t row, std::size_t column) const;
  /// @return false if the covariance is no longer positive definite
  [[nodiscard]] bool Factorise();

  Genome origin_;                  // start of the run; empty while it is being chosen
  std::vector<std::size_t> free_;  // genes that are searched
  std::size_t genes_ = 0;          // number of free genes
  bool full_ = true;
  Rules rules_{};
  std::vector<double> covariance_;  // lower triangle, row after row, or the diagonal
  std::vector<double> factor_;      // in the same layout; computed from the covariance
  std::vector<double> mean_, path_, sigma_path_;
  double sigma_ = 0.0;
  int population_ = 0;
  int run_ = 0;
  int age_ = 0;         // generations of this run, including its random genomes
  int generation_ = 1;  // counts over all runs, for the random numbers
  int stale_ = 0;       // generations without improvement
  float run_best_ = 0.0f;
  std::vector<float> last_fitness_;  // fitness of the last generation, for display; not saved
};

}  // namespace gaitsmith
