// SPDX-License-Identifier: MIT
// Pose cycles, then moves of rules: the search that needs a tenth of the evaluations. docs/search.md has the
// figures and the ablation.
//
// 1. Draws pose cycles (pose_cycle_form.h) from a prior.
// 2. Races runs of CMA-ES from the best of them [Hansen 2016]: after each rung the better half goes on
//    [Jamieson Talwalkar 2016], with twice the evaluations, until one is left.
// 3. Climbs from the best bank. Each child moves rules that act, or places a rule where the motion passes
//    (rule_moves.h). The best child of a generation takes the parent's place if it is as good as the parent,
//    or as the parent was some generations before: late acceptance [Burke Bykov 2017]. So the climb can leave
//    a summit; the search keeps the best of all.
//
// Where the body may change, each contender has its own throughout the race, the first of them the drawn one,
// and every third generation of the climb changes the body alone. So most genomes that are proposed together
// share a body, which lets them be simulated side by side.
//
// A search that is given a start begins with the third step. A trajectory has no rules: it runs through the
// poses of a cycle, and the climb perturbs its knots. A network has neither: the best of some random ones is
// perturbed.
#pragma once

#include "core/search/batch_search.h"
#include "core/search/cma_distribution.h"
#include "core/search/pose_cycle_form.h"

namespace gaitsmith {

class PoseCycle final : public BatchSearch {
 public:
  PoseCycle(const SearchSettings& settings, const SearchSpace& space);
  /// Best fitness of each run in the race, then that of the bank that climbs.
  [[nodiscard]] std::vector<float> PopulationFitness() const override;

 private:
  /// A run of CMA-ES over the points of one form.
  struct Contender {
    CycleForm form;
    Individual best;
    CmaDistribution distribution;
    int stream = 0;  // for its random numbers
    int evaluations = 0;
    int generations = 0;
    int stale = 0;  // generations without improvement
    bool ended = false;
  };

  [[nodiscard]] std::vector<Genome> Propose() const override;
  void Absorb(std::span<const Genome> batch, std::span<const Score> scores) override;
  void SaveState(BitWriter&) const override;
  [[nodiscard]] bool LoadState(BitReader&) override;

  /// Whether the controllers can be pose cycles.
  [[nodiscard]] bool HasCycles() const;
  [[nodiscard]] std::pair<CycleForm, std::vector<double>> Draw(int individual) const;
  /// The genes of the body that an individual of the first batch has.
  [[nodiscard]] Genome DrawBody(int individual) const;
  /// The genome of a point, with the body of another genome.
  [[nodiscard]] Genome GenomeOf(const CycleForm&, std::span<const double> point,
                                std::span<const Gene> body) const;
  [[nodiscard]] std::span<const Gene> BodyIn(const Genome& genome) const {
    return std::span(genome).last(Space().shape.BodyGenes());
  }
  /// A genome of which only the body differs.
  [[nodiscard]] Genome MoveBody(const Genome& parent, RandomStream&) const;
  [[nodiscard]] Contender Enter(const CycleForm&, std::vector<double> point, int stream) const;
  [[nodiscard]] bool InRung(const Contender& one) const { return !one.ended && one.evaluations < rung_; }
  /// The points of a contender's next generation, clamped to the cube.
  [[nodiscard]] std::vector<std::vector<double>> PointsOf(const Contender&) const;
  void BeginRace(std::span<const Score> scores);
  void Adapt(Contender&, std::span<const Score> scores);
  /// Ends the rungs that are complete, and at last the race.
  void EndRungs();
  void BeginClimb(Individual parent);
  /// Lets a generation's best child take the parent's place, or not.
  void Climb(Individual child);
  /// Looks at the motion of a genome.
  void See(Genome genome);

  int generation_ = 0;                 // batches so far
  int rung_ = 0;                       // evaluations of each contender at which the rung ends
  std::vector<Contender> contenders_;  // empty before and after the race
  Individual parent_;                  // of the climb; empty before it
  std::vector<float> past_;            // the parent's fitness in each of the last generations of the climb
  Genome seen_;                        // whose motion was looked at: that of the parent, or an equal one
  std::vector<Sighting> sightings_;    // of it; not saved, because they follow from it
};

}  // namespace gaitsmith
