// SPDX-License-Identifier: MIT
// Breeding by eye: children of motions that a person picked [Sims 1991; Dawkins 1986; Ventrella 1994]. The
// person chooses the manner, the search keeps it alive.
//
// 1. Scores the parents.
// 2. Births: children of one parent or hybrids of two, changed where they act (rule_moves.h). A greater
// wished
//    difference means more changes. Of those that move, children are chosen that look different from one
//    another and from the parents, but not too different from the nearest parent.
// 3. Climbs from each child at the same time. A change is kept if the motion becomes better at the goal and
//    still looks different from all other children.
//
// How motions look is measured by their traits (signal/traits.h), so the scores must have them.
#pragma once

#include "core/search/batch_search.h"

namespace gaitsmith {

/// What a person picked and wishes.
struct BreedWish {
  std::vector<Genome> parents;   // at least 1, of the space's shape
  int children = 9;              // [1, kMaxBrood]
  float difference = 0.3f;       // from the nearest parent, [0, 1]: hardly any to as much as there is
  bool keep_goal = false;        // prefers children that are good at the goal to ones that differ much
  std::vector<int> kept_rules;   // rules or knots that stay as in a child's first parent; not for networks
  std::vector<int> kept_joints;  // whose angles stay in all of them; not for networks
};
inline constexpr int kMaxBrood = 16;

class Brood final : public BatchSearch {
 public:
  /// @param settings seed, evaluations and variation are read
  Brood(const SearchSettings& settings, const SearchSpace& space, BreedWish wish);

  struct Member {
    Genome genome;
    float fitness = 0.0f;
    Traits traits{};
  };
  /// After the births: as many as were wished, fewer only if almost nothing moved.
  [[nodiscard]] const std::vector<Member>& Children() const { return children_; }
  /// The parents that were scored, in their order.
  [[nodiscard]] const std::vector<Member>& Parents() const { return parents_; }
  /// From the nearest parent. Infinite before the parents are scored.
  [[nodiscard]] float DistanceToParents(const Traits&) const;
  [[nodiscard]] std::vector<float> PopulationFitness() const override;

 private:
  [[nodiscard]] std::vector<Genome> Propose() const override;
  void Absorb(std::span<const Genome> batch, std::span<const Score> scores) override;
  void AbsorbRest(std::span<const Genome> batch, std::span<const Score> scores) override;
  [[nodiscard]] bool ReadsTraits() const override { return true; }
  void SaveState(BitWriter&) const override;
  [[nodiscard]] bool LoadState(BitReader&) override;

  /// A child of one or two parents.
  [[nodiscard]] Genome Bear(int individual) const;
  /// A changed copy in which what is kept is as in `model`.
  [[nodiscard]] Genome Change(const Genome& genome, std::span<const Sighting> sightings, int changes,
                              const Genome& model, RandomStream&) const;
  void PutBackKept(Genome& child, const Genome& model) const;
  [[nodiscard]] std::vector<Sighting> See(const Genome&) const;
  /// Least distance between children, and the greatest to the nearest parent.
  [[nodiscard]] float Apart(int leniency) const;
  [[nodiscard]] float Reach(int leniency) const;
  /// Indices of the born that can be the children. Fewer than are wished if there are no more.
  [[nodiscard]] std::vector<std::size_t> ChooseBorn(int leniency) const;
  void AddParent(const Genome&, const Score&);
  void AddBorn(std::span<const Genome> batch, std::span<const Score> scores);
  void EndBirths();
  /// Lets a changed child take the place of the one it comes from, or not.
  void Replace(std::size_t at, const Genome&, const Score&);

  BreedWish wish_;
  int generation_ = 0;            // batches so far
  int leniency_ = 0;              // with which the children were chosen
  std::vector<Member> parents_;   // empty before they are scored
  std::vector<Member> born_;      // that move; empty after the births
  std::vector<Member> children_;  // empty before the end of the births
  // Of the parents during the births, then of the children; not saved, because they follow from them.
  std::vector<std::vector<Sighting>> sightings_;
};

}  // namespace gaitsmith
