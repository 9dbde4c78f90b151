// SPDX-License-Identifier: MIT
#include "core/evolution/nsga.h"

#include <algorithm>
#include <array>

namespace gaitsmith {

namespace {

/// Of the random numbers that draw tournaments: individuals that no batch has.
constexpr int kTournaments = 1 << 30;
constexpr float kVoid = -std::numeric_limits<float>::infinity();

Aims AimsOf(const Score& score, Cost cost) {
  const float spent = CostOf(score.traits, cost);
  if (!(score.fitness > kNoMotion) || !(spent - spent == 0.0f)) return {kVoid, kVoid};
  return {score.fitness, 0.0f - spent};
}

/// Best first: by front, then the less crowded, then as they are.
void SortBest(std::vector<Compromise>& members) {
  std::vector<Aims> aims;
  aims.reserve(members.size());
  for (const Compromise& one : members) aims.push_back(one.aims);
  const std::vector<int> fronts = FrontsOf(aims);
  const std::vector<double> crowding = CrowdingOf(aims, fronts);
  std::vector<std::size_t> order(members.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    if (fronts[a] != fronts[b]) return fronts[a] < fronts[b];
    return crowding[a] != crowding[b] ? crowding[a] > crowding[b] : a < b;
  });
  std::vector<Compromise> sorted;
  sorted.reserve(members.size());
  for (const std::size_t i : order) sorted.push_back(std::move(members[i]));
  members = std::move(sorted);
}

void PutMembers(BitWriter& out, const std::vector<Compromise>& members) {
  out.Put(members.size(), 32);
  for (const Compromise& one : members) {
    PutGenome(out, one.genome, one.aims.score);
    out.Put(std::bit_cast<std::uint32_t>(one.aims.thrift), 32);
  }
}

/// @return false if these cannot be members
bool TakeMembers(BitReader& in, std::vector<Compromise>& members, std::size_t most, std::size_t genes) {
  members.clear();
  const auto size = static_cast<std::size_t>(in.Take(32));
  if (size > most) return false;
  for (std::size_t i = 0; i < size && !in.Overrun(); ++i) {
    Compromise one;
    if (!TakeGenome(in, one.genome, one.aims.score, genes) || one.genome.size() != genes) return false;
    one.aims.thrift = std::bit_cast<float>(static_cast<std::uint32_t>(in.Take(32)));
    const bool is_void = one.aims.score == kVoid && one.aims.thrift == kVoid;
    const auto finite = [](float value) { return value - value == 0.0f; };
    if (!is_void && !(finite(one.aims.score) && finite(one.aims.thrift))) return false;
    members.push_back(std::move(one));
  }
  return true;
}

}  // namespace

std::vector<float> Nsga::PopulationFitness() const {
  std::vector<float> fitness;
  fitness.reserve(members_.size());
  for (const Compromise& one : members_) fitness.push_back(one.aims.score);
  return fitness;
}

std::vector<std::size_t> Nsga::Winners() const {
  std::vector<std::size_t> winners;
  for (int round = 0; round < 2; ++round) {
    RandomStream random = Stream(kTournaments + round, generation_);
    std::vector<std::size_t> order(members_.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      const std::size_t other = random.Below(static_cast<std::uint32_t>(i + 1));
      order[i] = order[other];
      order[other] = i;
    }
    // They are sorted, so the winner is the one in front. Of an odd number one has no rival.
    for (std::size_t i = 0; i < order.size(); i += 2) {
      winners.push_back(i + 1 < order.size() ? std::min(order[i], order[i + 1]) : order[i]);
    }
  }
  return winners;
}

std::vector<Genome> Nsga::Propose() const {
  const auto size = static_cast<std::size_t>(Settings().genetic.population);
  std::vector<Genome> batch;
  batch.reserve(size + 1);
  if (members_.empty()) {
    for (int i = 0; std::cmp_less(i, size); ++i) batch.push_back(First(i));
    return batch;
  }
  const std::vector<std::size_t> winners = Winners();
  for (int pair = 0; batch.size() < size; ++pair) {
    RandomStream random = Stream(pair, generation_);
    const auto first = 2 * static_cast<std::size_t>(pair);
    const Genome& one = members_[winners[first]].genome;
    const Genome& other = members_[winners[std::min(first + 1, winners.size() - 1)]].genome;
    Offspring children = Breed(one, other, Space(), Settings().variation, Settings().genetic.rates, random);
    batch.push_back(std::move(children.copy));
    batch.push_back(std::move(children.hybrid));
  }
  batch.resize(size);  // for an odd population the last hybrid is dropped
  return batch;
}

void Nsga::Absorb(std::span<const Genome> batch, std::span<const Score> scores) {
  for (std::size_t i = 0; i < batch.size(); ++i) {
    members_.push_back({batch[i], AimsOf(scores[i], Settings().cost)});
  }
  SortBest(members_);
  members_.resize(static_cast<std::size_t>(Settings().genetic.population));
  ++generation_;
}

void Nsga::SaveState(BitWriter& out) const {
  out.Put(static_cast<std::uint32_t>(generation_), 32);
  PutMembers(out, members_);
}

bool Nsga::LoadState(BitReader& in) {
  const auto size = static_cast<std::size_t>(Settings().genetic.population);
  return TakeCount(in, generation_, Settings().evaluations) &&
         TakeMembers(in, members_, size, Space().shape.Genes()) &&
         members_.size() == (generation_ > 0 ? size : 0);
}

std::optional<std::vector<Compromise>> FrontOf(const SearchSettings& settings, std::size_t genes,
                                               std::span<const std::uint8_t> state) {
  BitReader in(state);
  BatchHead head;
  int generation = 0;
  std::vector<Compromise> members;
  if (!TakeBatchHead(in, head, settings.evaluations, genes, true)) return std::nullopt;
  if (!TakeCount(in, generation, settings.evaluations)) return std::nullopt;
  if (!TakeMembers(in, members, static_cast<std::size_t>(settings.genetic.population), genes))
    return std::nullopt;
  ProgressCurve curve;
  curve.Load(in);
  if (in.Overrun() || !in.AtEnd()) return std::nullopt;
  std::erase_if(members, [](const Compromise& one) { return one.aims.score == kVoid; });
  std::vector<Aims> aims;
  aims.reserve(members.size());
  for (const Compromise& one : members) aims.push_back(one.aims);
  const std::vector<int> fronts = FrontsOf(aims);
  std::vector<Compromise> front;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (fronts[i] == 0) front.push_back(std::move(members[i]));
  }
  std::ranges::sort(front, [](const Compromise& a, const Compromise& b) {
    return a.aims.score != b.aims.score ? a.aims.score < b.aims.score : a.genome < b.genome;
  });
  const auto alike = std::ranges::unique(front, [](const Compromise& a, const Compromise& b) {
    return a.aims.score == b.aims.score && a.aims.thrift == b.aims.thrift;
  });
  front.erase(alike.begin(), alike.end());
  return front;
}

std::unique_ptr<Search> MakeNsga(const SearchSettings& settings, const SearchSpace& space) {
  return std::make_unique<Nsga>(settings, space);
}

}  // namespace gaitsmith
