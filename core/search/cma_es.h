// SPDX-License-Identifier: MIT
// Covariance matrix adaptation evolution strategy (CMA-ES) [Hansen 2016] over the unit cube of genes, in full
// or with variances only [Ros Hansen 2008], restarted with a larger population when it stalls
// [Auger Hansen 2005].
//
//   x_k = m + sigma A z_k,   A A^T = C,   z_k normal
//
// A is the Cholesky factor, as in [Krause 2016], not the symmetric root: its few loops sum in one fixed order
// everywhere, which an eigensolver with cache-dependent blocks would not. Samples are moved to the nearest
// genome before they count, so the distribution learns from what was simulated.
//
// A run begins at the best of some random genomes, the first run at the start if one is given. Which senses
// its rules ignore is settled by that genome: an interval over the whole range is a gate, not a number, and
// noise on it would make every rule care about everything, so that none ever fires.
#pragma once

#include "core/search/batch_search.h"

namespace gaitsmith {

class CmaEs final : public BatchSearch {
 public:
  CmaEs(const SearchSettings& settings, const SearchSpace& space);
  [[nodiscard]] std::vector<float> PopulationFitness() const override { return last_fitness_; }

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
  /// Random genomes that this run begins with.
  [[nodiscard]] int Draws() const;
  /// Settles which genes are free, and everything that depends on how many they are.
  void BeginAt(const Genome& origin, int population);
  [[nodiscard]] std::vector<double> FreePointOf(const Genome&) const;
  void Adapt(std::span<const Genome> batch, std::span<const Score> scores);
  [[nodiscard]] bool Stalled() const;
  /// Row of the lower triangle of the covariance or its factor; the separable one has the diagonal alone.
  [[nodiscard]] std::size_t At(std::size_t row, std::size_t column) const;
  /// @return false when the covariance is not positive definite any more
  [[nodiscard]] bool Factorise();

  Genome origin_;                  // that the run began at; empty while it is looked for
  std::vector<std::size_t> free_;  // genes that are searched
  std::size_t genes_ = 0;          // their number
  bool full_ = true;
  Rules rules_{};
  std::vector<double> covariance_;  // lower triangle, row after row, or the diagonal
  std::vector<double> factor_;      // likewise; follows from the covariance
  std::vector<double> mean_, path_, sigma_path_;
  double sigma_ = 0.0;
  int population_ = 0;
  int run_ = 0;
  int age_ = 0;         // generations of this run, its random genomes included
  int generation_ = 1;  // of all runs, for the random numbers
  int stale_ = 0;       // generations without a better one
  float run_best_ = 0.0f;
  std::vector<float> last_fitness_;  // of the last generation, for display: not saved
};

}  // namespace gaitsmith
