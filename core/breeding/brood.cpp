// SPDX-License-Identifier: MIT
#include "core/breeding/brood.h"

#include <limits>

#include "core/search/rule_moves.h"

namespace gaitsmith {

namespace {

constexpr int kBirths = 96;   // of a batch
constexpr int kClimbers = 4;  // of each child's generation: one register
constexpr int kSeen = 32;
constexpr float kApart = 0.15f;  // two motions that plainly differ
constexpr float kLeastReach = 0.2f;
constexpr float kCloser = 0.95f;  // factor of the distance for each degree of leniency
constexpr float kWider = 1.2f;    // factor of the reach: sameness is worse than difference
constexpr int kMostLenient = 12;  // degrees, if there are too few children
constexpr int kMostChanges = 12;  // at a birth
constexpr int kTries = 8;         // until a child differs from what it was made of

/// Whether something moves most of the time.
bool Moves(const Score& score) {
  const bool finite = std::ranges::all_of(score.traits, [](float value) { return value - value == 0.0f; });
  return score.fitness > kNoMotion && finite && TraitOf(score.traits, Trait::kStill) < 0.7f;
}

}  // namespace

Brood::Brood(const SearchSettings& settings, const SearchSpace& space, BreedWish wish)
    : BatchSearch(settings, space), wish_(std::move(wish)) {}

std::vector<float> Brood::PopulationFitness() const {
  std::vector<float> fitness;
  for (const Member& one : children_.empty() ? born_ : children_) fitness.push_back(one.fitness);
  return fitness;
}

std::vector<Sighting> Brood::See(const Genome& genome) const {
  return Space().sightings ? Space().sightings(genome, kSeen) : std::vector<Sighting>{};
}

void Brood::PutBackKept(Genome& child, const Genome& model) const {
  const ControllerShape& shape = Space().shape;
  if (shape.Kind() == ControllerKind::kNetwork) return;
  const auto angle = [&](int rule, int joint) {
    return shape.Kind() == ControllerKind::kTrajectory ? shape.Curves().Angle(rule, joint)
                                                       : shape.Bank().Target(rule, joint);
  };
  for (const int rule : wish_.kept_rules) {
    for (std::size_t at = shape.Begin(rule); at < shape.Begin(rule + 1); ++at) child[at] = model[at];
  }
  for (const int joint : wish_.kept_joints) {
    for (int rule = 0; rule < shape.Bank().rules; ++rule)
      child[angle(rule, joint)] = model[angle(rule, joint)];
  }
}

Genome Brood::Change(const Genome& genome, std::span<const Sighting> sightings, int changes,
                     const Genome& model, RandomStream& random) const {
  const ControllerShape& shape = Space().shape;
  Genome child = genome;
  for (int tries = 0; tries < kTries; ++tries) {
    for (int i = 0; i < changes; ++i) {
      child = shape.Kind() == ControllerKind::kRules
                  ? MoveRules(child, sightings, shape.Bank(), random)
                  : Perturb(child, shape, Space().senses, Settings().variation, random);
    }
    PutBackKept(child, model);
    if (child != genome) break;  // what is kept may be all that has changed
  }
  return child;
}

Genome Brood::Bear(int individual) const {
  RandomStream random = Stream(individual, generation_);
  const auto any = [&] { return random.Below(static_cast<std::uint32_t>(parents_.size())); };
  const std::size_t first = any(), second = any();
  const Genome& model = parents_[first].genome;
  Genome child = model;
  if (first != second) {
    const Rates rates{.crossover = 1.0f};
    child = Cross(parents_[second].genome, model, Space().shape, rates, random);
  }
  const auto most = static_cast<std::uint32_t>(static_cast<float>(kMostChanges) * wish_.difference);
  return Change(child, sightings_[first], 1 + static_cast<int>(random.Below(most + 1)), model, random);
}

std::vector<Genome> Brood::Propose() const {
  if (parents_.empty()) return wish_.parents;
  std::vector<Genome> batch;
  if (children_.empty()) {
    for (int i = 0; i < kBirths; ++i) batch.push_back(Bear(i));
    return batch;
  }
  for (std::size_t i = 0; i < children_.size(); ++i) {
    for (int k = 0; k < kClimbers; ++k) {
      RandomStream random = Stream(static_cast<int>(i) * kClimbers + k, generation_);
      const Genome& child = children_[i].genome;
      batch.push_back(Change(child, sightings_[i], 1, child, random));
    }
  }
  return batch;
}

float Brood::DistanceToParents(const Traits& traits) const {
  float least = std::numeric_limits<float>::infinity();
  for (const Member& parent : parents_) least = std::min(least, TraitDistance(traits, parent.traits));
  return least;
}

float Brood::Apart(int leniency) const {
  float apart = kApart;
  for (int i = 0; i < leniency; ++i) apart *= kCloser;
  return apart;
}

float Brood::Reach(int leniency) const {
  float reach = kLeastReach + (1.0f - kLeastReach) * wish_.difference;
  for (int i = 0; i < leniency; ++i) reach *= kWider;
  return reach;
}

void Brood::Absorb(std::span<const Genome> batch, std::span<const Score> scores) {
  ++generation_;
  if (parents_.empty()) {
    for (std::size_t i = 0; i < batch.size(); ++i) AddParent(batch[i], scores[i]);
  } else if (children_.empty()) {
    AddBorn(batch, scores);
    if (static_cast<int>(ChooseBorn(0).size()) == wish_.children ||
        2 * Evaluations() >= Settings().evaluations)
      EndBirths();
  } else {
    for (std::size_t i = 0; i < children_.size(); ++i) {
      for (std::size_t k = i * kClimbers; k < (i + 1) * kClimbers; ++k) Replace(i, batch[k], scores[k]);
    }
  }
}

void Brood::AbsorbRest(std::span<const Genome> batch, std::span<const Score> scores) {
  if (parents_.empty() || !children_.empty()) return;
  AddBorn(batch, scores);
  EndBirths();
}

void Brood::AddParent(const Genome& genome, const Score& score) {
  Member parent{genome, score.fitness, score.traits};
  for (float& value : parent.traits)
    value = value - value == 0.0f ? value : 0.0f;  // it may have broken physics
  parents_.push_back(std::move(parent));
  sightings_.push_back(See(genome));
}

void Brood::AddBorn(std::span<const Genome> batch, std::span<const Score> scores) {
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (Moves(scores[i])) born_.push_back({batch[i], scores[i].fitness, scores[i].traits});
  }
}

std::vector<std::size_t> Brood::ChooseBorn(int leniency) const {
  const float apart = Apart(leniency), reach = Reach(leniency);
  std::vector<std::size_t> chosen;
  std::vector<float> distance;  // to the nearest parent or chosen child
  for (const Member& one : born_) {
    const float from_parents = DistanceToParents(one.traits);
    distance.push_back(from_parents <= reach ? from_parents : 0.0f);
  }
  while (static_cast<int>(chosen.size()) < wish_.children) {
    const bool by_fitness = wish_.keep_goal || chosen.empty();
    std::size_t best = born_.size();
    for (std::size_t i = 0; i < born_.size(); ++i) {
      if (distance[i] < apart) continue;
      const bool better = best == born_.size() || (by_fitness ? born_[i].fitness > born_[best].fitness
                                                              : distance[i] > distance[best]);
      if (better) best = i;
    }
    if (best == born_.size()) break;
    chosen.push_back(best);
    for (std::size_t i = 0; i < born_.size(); ++i)
      distance[i] = std::min(distance[i], TraitDistance(born_[i].traits, born_[best].traits));
  }
  return chosen;
}

void Brood::EndBirths() {
  std::vector<std::size_t> chosen = ChooseBorn(leniency_ = 0);
  while (static_cast<int>(chosen.size()) < wish_.children && leniency_ < kMostLenient)
    chosen = ChooseBorn(++leniency_);
  if (chosen.empty()) return;
  sightings_.clear();
  for (const std::size_t i : chosen) {
    children_.push_back(std::move(born_[i]));
    sightings_.push_back(See(children_.back().genome));
  }
  born_.clear();
}

void Brood::Replace(std::size_t at, const Genome& genome, const Score& score) {
  Member& child = children_[at];
  if (!Moves(score) || !(score.fitness > child.fitness)) return;
  const float from_parents = DistanceToParents(score.traits);
  if (from_parents < Apart(leniency_) || from_parents > Reach(leniency_)) return;
  const bool alone = std::ranges::all_of(children_, [&](const Member& other) {
    return &other == &child || TraitDistance(score.traits, other.traits) >= Apart(leniency_);
  });
  if (!alone) return;
  child = {genome, score.fitness, score.traits};
  sightings_[at] = See(genome);
}

namespace {

void PutMembers(BitWriter& out, const std::vector<Brood::Member>& members) {
  out.Put(members.size(), 32);
  for (const Brood::Member& one : members) {
    PutGenome(out, one.genome, one.fitness);
    PutTraits(out, one.traits);
  }
}

bool TakeMembers(BitReader& in, std::vector<Brood::Member>& members, int most, std::size_t genes) {
  int count = 0;
  members.clear();
  if (!TakeCount(in, count, most)) return false;
  for (int i = 0; i < count && !in.Overrun(); ++i) {
    Brood::Member one;
    if (!TakeGenome(in, one.genome, one.fitness, genes) || one.genome.empty()) return false;
    if (!TakeTraits(in, one.traits)) return false;
    members.push_back(std::move(one));
  }
  return true;
}

}  // namespace

void Brood::SaveState(BitWriter& out) const {
  out.Put(static_cast<std::uint32_t>(generation_), 32);
  out.Put(static_cast<std::uint32_t>(leniency_), 32);
  PutMembers(out, parents_);
  PutMembers(out, born_);
  PutMembers(out, children_);
}

bool Brood::LoadState(BitReader& in) {
  const std::size_t genes = Space().shape.Genes();
  const int most = Settings().evaluations;
  const auto wanted = static_cast<int>(wish_.parents.size());
  if (!TakeCount(in, generation_, most) || !TakeCount(in, leniency_, kMostLenient)) return false;
  if (!TakeMembers(in, parents_, wanted, genes) || !TakeMembers(in, born_, most, genes) ||
      !TakeMembers(in, children_, wish_.children, genes))
    return false;
  sightings_.clear();
  if (in.Overrun()) return true;  // the caller reports the error
  if (!parents_.empty() && static_cast<int>(parents_.size()) != wanted) return false;
  if (parents_.empty() && (!born_.empty() || !children_.empty())) return false;
  if (!born_.empty() && !children_.empty()) return false;
  for (const Member& one : children_.empty() ? parents_ : children_) sightings_.push_back(See(one.genome));
  return true;
}

}  // namespace gaitsmith
