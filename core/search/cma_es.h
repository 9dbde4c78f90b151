// SPDX-License-Identifier: MIT
// Covariance matrix adaptation evolution strategy (CMA-ES) [Hansen 2016] over the unit cube of genes. It
// restarts with a larger population when it stalls [Auger Hansen 2005]. Samples are rounded to the nearest
// genome before they are used, so the distribution learns from what was simulated.
//
// A run begins at the best of some random genomes. The first run begins at the given start, if there is one.
// That genome also determines which senses its rules ignore: an interval over the whole range is a switch,
// not a number. Noise on it would make every rule use every sense, so that no rule would ever match.
#pragma once

#include "core/search/batch_search.h"
#include "core/search/cma_distribution.h"

namespace gaitsmith {

class CmaEs final : public BatchSearch {
 public:
  CmaEs(const SearchSettings& settings, const SearchSpace& space);
  [[nodiscard]] std::vector<float> PopulationFitness() const override { return last_fitness_; }

 private:
  [[nodiscard]] std::vector<Genome> Propose() const override;
  void Absorb(std::span<const Genome> batch, std::span<const Score> scores) override;
  void SaveState(BitWriter&) const override;
  [[nodiscard]] bool LoadState(BitReader&) override;

  [[nodiscard]] int FirstPopulation() const;
  /// Number of random genomes drawn at the start of this run.
  [[nodiscard]] int Draws() const;
  /// Determines which genes are free, and sets up everything that depends on their number.
  void BeginAt(const Genome& origin, int population);
  [[nodiscard]] std::vector<double> FreePointOf(const Genome&) const;
  void Adapt(std::span<const Genome> batch, std::span<const Score> scores);
  [[nodiscard]] bool Stalled() const;

  Genome origin_;                  // start of the run; empty while it is being chosen
  std::vector<std::size_t> free_;  // genes that are searched
  CmaDistribution distribution_;   // over the free genes
  int population_ = 0;
  int run_ = 0;
  int age_ = 0;         // generations of this run, including its random genomes
  int generation_ = 1;  // counts over all runs, for the random numbers
  int stale_ = 0;       // generations without improvement
  float run_best_ = 0.0f;
  std::vector<float> last_fitness_;  // fitness of the last generation, for display; not saved
};

}  // namespace gaitsmith
