// SPDX-License-Identifier: MIT
// What searches share that go batch by batch: they name a batch of genomes, learn the scores of all of it,
// and name the next: a generation, a pair of children, one step of a simplex. A batch is handed out in pieces
// of any size, and what follows from it depends on the whole alone. The budget may end in the middle of a
// batch.
#pragma once

#include "core/search/genome_bits.h"
#include "core/search/progress_curve.h"
#include "core/search/search.h"

namespace gaitsmith {

class BatchSearch : public Search {
 public:
  using Search::Tell;
  [[nodiscard]] std::vector<Genome> Ask(int wanted) final;
  void Tell(std::span<const Score> scores) final;
  [[nodiscard]] int Evaluations() const final { return evaluations_; }
  [[nodiscard]] bool Done() const final { return evaluations_ >= settings_.evaluations; }
  [[nodiscard]] const Genome& BestGenome() const final { return best_; }
  [[nodiscard]] float BestFitness() const final { return best_fitness_; }
  [[nodiscard]] const std::vector<CurvePoint>& Curve() const final { return curve_.Points(); }
  void Save(BitWriter&) const final;
  [[nodiscard]] Result<void> Load(BitReader&) final;

 protected:
  BatchSearch(const SearchSettings& settings, const SearchSpace& space)
      : settings_(settings), space_(space) {}

  /// The next batch, at least one genome: a function of the state that SaveState saves, and of nothing else.
  [[nodiscard]] virtual std::vector<Genome> Propose() const = 0;
  /// Scores of the whole batch, fitness a number or minus infinity.
  virtual void Absorb(std::span<const Genome> batch, std::span<const Score> scores) = 0;
  /// The part of a batch that the budget's end allowed. Nothing is proposed after it.
  virtual void AbsorbRest(std::span<const Genome>, std::span<const Score>) {}
  virtual void SaveState(BitWriter&) const = 0;
  /// @return false when it cannot be a state of this search; then it may have been taken in part. Whoever
  /// reads past the end reads zeros and need not look out.
  [[nodiscard]] virtual bool LoadState(BitReader&) = 0;

  [[nodiscard]] const SearchSettings& Settings() const { return settings_; }
  [[nodiscard]] const SearchSpace& Space() const { return space_; }
  [[nodiscard]] Genome First(int individual) const {
    return FirstGenome(space_, settings_.variation, settings_.seed, individual);
  }
  /// Random numbers of a child's own.
  [[nodiscard]] RandomStream Stream(int individual, int generation) const {
    return {settings_.seed, static_cast<std::uint64_t>(individual), static_cast<std::uint64_t>(generation)};
  }

 private:
  [[nodiscard]] bool Read(BitReader&);

  SearchSettings settings_;
  SearchSpace space_;
  std::vector<Genome> batch_;  // empty before it is asked for
  std::vector<Score> told_;    // of the batch, as far as known
  int evaluations_ = 0;
  Genome best_;
  float best_fitness_ = -std::numeric_limits<float>::infinity();
  ProgressCurve curve_;
};

/// A genome with its fitness: a member of a population.
struct Individual {
  Genome genome;
  float fitness = -std::numeric_limits<float>::infinity();
};

[[nodiscard]] std::vector<float> FitnessOf(const std::vector<Individual>&);

void PutPopulation(BitWriter&, const std::vector<Individual>&);
/// @param most members at most. @return false when it cannot be a population
[[nodiscard]] bool TakePopulation(BitReader&, std::vector<Individual>&, std::size_t most, std::size_t genes);

void PutReal(BitWriter&, double);
/// @return false unless it is finite
[[nodiscard]] bool TakeReal(BitReader&, double&);
/// @return false unless it is in [0, most]
[[nodiscard]] bool TakeCount(BitReader&, int& count, int most);

}  // namespace gaitsmith
