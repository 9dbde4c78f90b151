// SPDX-License-Identifier: MIT
// Random generate-and-test (RG&T): the paper's benchmark [Fukunaga 1994, section 3].
#pragma once

#include "core/search/progress_curve.h"
#include "core/search/search.h"

namespace gaitsmith {

class RandomSearch final : public Search {
 public:
  RandomSearch(const SearchSettings&, const SearchSpace&);

  [[nodiscard]] std::vector<Genome> Ask(int wanted) override;
  using Search::Tell;
  void Tell(std::span<const Score> scores) override;
  [[nodiscard]] int Evaluations() const override { return evaluations_; }
  [[nodiscard]] bool Done() const override { return evaluations_ >= settings_.evaluations; }
  [[nodiscard]] const Genome& BestGenome() const override { return best_; }
  [[nodiscard]] float BestFitness() const override { return best_fitness_; }
  [[nodiscard]] const std::vector<CurvePoint>& Curve() const override { return curve_.Points(); }
  [[nodiscard]] std::vector<float> PopulationFitness() const override { return {}; }
  void Save(BitWriter&) const override;
  [[nodiscard]] Result<void> Load(BitReader&) override;

 private:
  [[nodiscard]] Genome Draw(int evaluation) const;

  SearchSettings settings_;
  SearchSpace space_;
  int evaluations_ = 0;
  Genome best_;
  float best_fitness_;
  ProgressCurve curve_;
};

}  // namespace gaitsmith
