// SPDX-License-Identifier: MIT
// The search from the paper on sensor-actuator networks [VanDePanne Fiume 1993]: random generate-and-test
// finds some controllers that move at all, then stochastic ascent refines the best of them independently.
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

  std::vector<Individual> kept_;  // empty during the first stage
  int generation_ = 0;
};

}  // namespace gaitsmith
