// SPDX-License-Identifier: MIT
// Covariance matrix adaptation MAP-annealing, CMA-MAE [Fontaine Nikolaidis 2023]: the grid of MAP-Elites,
// whose children are samples of several runs of CMA-ES side by side. A run learns to improve on what the
// cells ask for, not on its own best. A cell first asks for what the least fit random motion had, f_min; each
// motion that has more raises that:
//
//   improvement = f - t,   t <- (1 - alpha) t + alpha f   if it is positive
//
// So a run first climbs where it is, and leaves when its cells ask for too much. With alpha = 0 it climbs for
// ever, as CMA-ES does; with alpha = 1 a cell asks for its elite's fitness at once.
#pragma once

#include "core/evolution/elites.h"
#include "core/search/batch_search.h"
#include "core/search/cma_run.h"

namespace gaitsmith {

class CmaMae final : public BatchSearch {
 public:
  CmaMae(const SearchSettings& settings, const SearchSpace& space);

  [[nodiscard]] std::vector<float> PopulationFitness() const override { return elites_.Fitness(); }
  /// As Elites::Cells.
  [[nodiscard]] const std::vector<Elite>& Cells() const { return elites_.Cells(); }

 private:
  [[nodiscard]] std::vector<Genome> Propose() const override;
  void Absorb(std::span<const Genome> batch, std::span<const Score> scores) override;
  void AbsorbRest(std::span<const Genome> batch, std::span<const Score> scores) override;
  void SaveState(BitWriter&) const override;
  [[nodiscard]] bool LoadState(BitReader&) override;

  struct Emitter {
    CmaRun run;
    int age = 0;    // generations of this run
    int stale = 0;  // of them without an improvement
  };
  /// A run from a random elite. @param at which emitter
  [[nodiscard]] Emitter Begin(int at) const;
  [[nodiscard]] CmaRun RunFrom(Genome origin) const;
  /// Keeps a motion, and raises what its cell asks for. @return its improvement, -infinity if it is void
  float Improve(const Genome&, const Score&);

  Elites elites_;
  std::vector<float> asked_;  // of each cell; empty before the first batch is scored
  std::vector<Emitter> emitters_;
  int generation_ = 0;
};

}  // namespace gaitsmith
