// SPDX-License-Identifier: MIT
// The search that sensor-actuator networks came with [VanDePanne Fiume 1993]: random generate-and-test
// finds some controllers that do anything at all, then stochastic ascent refines the best of them, each on
// its own.
#pragma once

#include "core/search/batch_search.h"

namespace gaitsmith {

class TwoStage final : public BatchSearch {
 public:
  TwoStage(const SearchSettings& settings, const SearchSpace& space) : BatchSearch(settings, space) {}
  [[nodiscard]] std::vector<float> PopulationFitness() const override { return FitnessOf(kept_); }

 private:
  [[nodiscard]] std::vector<Genome> Propose() const override;
  void Absorb(std::span<const Genome> batch, std::span<const Score> scores) override;
  void SaveState(BitWriter&) const override;
  [[nodiscard]] bool LoadState(BitReader&) override;

  std::vector<Individual> kept_;  // empty in the first stage
  int generation_ = 0;
};

}  // namespace gaitsmith
