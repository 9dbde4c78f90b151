// SPDX-License-Identifier: MIT
// Covariance matrix adaptation evolution strategy (CMA-ES) [Hansen 2016] with restarts.
//
// A run (cma_run.h) begins at the best of some random genomes. The first run begins at the given start, if
// there is one. A run that stalls is followed by one with a larger population [Auger Hansen 2005]. In BIPOP
// [Hansen 2009] that alternates with runs of a small population and a smaller first step,
//
//   lambda = lambda_0 (lambda_large / (2 lambda_0))^(u^2),   sigma = sigma_0 10^(-2 u'),   u, u' uniform
//
// so that both kinds spend as many evaluations: the one that has spent less goes next.
#pragma once

#include <array>

#include "core/search/batch_search.h"
#include "core/search/cma_run.h"

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

  /// Number of random genomes drawn at the start of this run.
  [[nodiscard]] int Draws() const;
  [[nodiscard]] bool Bipop() const { return Settings().cma.restarts == Restarts::kBipop; }
  /// Sets up a run from a genome, of this run's kind.
  void BeginAt(const Genome& origin);
  /// Determines the kind of the next run.
  void EndRun();

  CmaRun run_;          // not begun while its origin is being chosen
  int population_ = 0;  // of this run, once it has begun; before the first: 0
  int runs_ = 0;        // that ended
  int age_ = 0;         // generations of this run, including its random genomes
  int generation_ = 1;  // counts over all runs, for the random numbers
  int stale_ = 0;       // generations without improvement
  float run_best_ = 0.0f;
  // BIPOP only.
  bool small_ = false;                 // whether this run has a small population
  int large_ = 0;                      // population of the last large run
  std::array<int, 2> spent_ = {0, 0};  // evaluations of large and of small runs
  std::vector<float> last_fitness_;    // fitness of the last generation, for display; not saved
};

}  // namespace gaitsmith
