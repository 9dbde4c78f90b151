// SPDX-License-Identifier: MIT
// Base class of searches that work in batches: they propose a batch of genomes, receive the scores of the
// whole batch, and propose the next. A batch is a generation, a pair of children or one step of a simplex,
// for example. Ask may hand out a batch in pieces of any size. The next batch depends only on the whole. The
// budget may end in the middle of a batch.
#pragma once

#include "core/control/genome_bits.h"
#include "core/search/progress_curve.h"
#include "core/search/search.h"

namespace gaitsmith {

/// What the saved state of every such search begins with.
struct BatchHead {
  int evaluations = 0;
  Genome best;
  float best_fitness = -std::numeric_limits<float>::infinity();
  std::vector<Score> scores;  // of the batch, received so far
};
/// @param budget the search's evaluations. @param traits whether scores have them
/// @return false if it cannot be a search's; it may then have been taken in part
[[nodiscard]] bool TakeBatchHead(BitReader&, BatchHead&, int budget, std::size_t genes, bool traits = false);

class BatchSearch : public Search {
 public:
  using Search::Tell;
  [[nodiscard]] std::vector<Genome> Ask(int wanted) final;
  void Tell(std::span<const Score> scores) final;
  [[nodiscard]] int Evaluations() const final { return head_.evaluations; }
  [[nodiscard]] bool Done() const final { return head_.evaluations >= settings_.evaluations; }
  [[nodiscard]] const Genome& BestGenome() const final { return head_.best; }
  [[nodiscard]] float BestFitness() const final { return head_.best_fitness; }
  [[nodiscard]] const std::vector<CurvePoint>& Curve() const final { return curve_.Points(); }
  void Save(BitWriter&) const final;
  [[nodiscard]] Result<void> Load(BitReader&) final;

 protected:
  BatchSearch(const SearchSettings& settings, const SearchSpace& space)
      : settings_(settings), space_(space) {}

  /// The next batch, at least one genome. Depends only on the state that SaveState saves.
  [[nodiscard]] virtual std::vector<Genome> Propose() const = 0;
  /// Receives the scores of the whole batch. Each fitness is a number or minus infinity.
  virtual void Absorb(std::span<const Genome> batch, std::span<const Score> scores) = 0;
  /// Receives the part of a batch that was scored before the budget ended. No batch is proposed after it.
  virtual void AbsorbRest(std::span<const Genome>, std::span<const Score>) {}
  /// Whether scores have traits that a saved search must keep.
  [[nodiscard]] virtual bool ReadsTraits() const { return false; }
  virtual void SaveState(BitWriter&) const = 0;
  /// @return false if this cannot be a state of this search; it may then have been loaded in part. Reading
  /// past the end gives zeros, so implementations need not check for it.
  [[nodiscard]] virtual bool LoadState(BitReader&) = 0;

  [[nodiscard]] const SearchSettings& Settings() const { return settings_; }
  [[nodiscard]] const SearchSpace& Space() const { return space_; }
  [[nodiscard]] Genome First(int individual) const {
    return FirstGenome(space_, settings_.variation, settings_.seed, individual);
  }
  /// A separate random stream for each child.
  [[nodiscard]] RandomStream Stream(int individual, int generation) const {
    return {settings_.seed, static_cast<std::uint64_t>(individual), static_cast<std::uint64_t>(generation)};
  }

 private:
  [[nodiscard]] bool Read(BitReader&);

  SearchSettings settings_;
  SearchSpace space_;
  std::vector<Genome> batch_;  // empty until the first Ask
  BatchHead head_;
  ProgressCurve curve_;
};

/// A genome with its fitness: a member of a population.
struct Individual {
  Genome genome;
  float fitness = -std::numeric_limits<float>::infinity();
};

[[nodiscard]] std::vector<float> FitnessOf(const std::vector<Individual>&);

void PutPopulation(BitWriter&, const std::vector<Individual>&);
/// @param most maximum number of members. @return false if this cannot be a population
[[nodiscard]] bool TakePopulation(BitReader&, std::vector<Individual>&, std::size_t most, std::size_t genes);

void PutTraits(BitWriter&, const Traits&);
/// @return false unless all are finite
[[nodiscard]] bool TakeTraits(BitReader&, Traits&);

void PutReal(BitWriter&, double);
/// @return false unless the value is finite
[[nodiscard]] bool TakeReal(BitReader&, double&);
/// @return false unless the count is in [0, most]
[[nodiscard]] bool TakeCount(BitReader&, int& count, int most);

}  // namespace gaitsmith
