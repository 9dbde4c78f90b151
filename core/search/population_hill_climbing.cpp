// SPDX-License-Identifier: MIT
#include "core/search/population_hill_climbing.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "core/control/genome_bits.h"

namespace gaitsmith {

namespace {

/// Least number of perturbations of one parent that are proposed together, if more than one per parent is
/// wanted. They share many stimuli, so they simulate faster side by side.
constexpr int kMinAhead = 4;

}  // namespace

PopulationHillClimbing::PopulationHillClimbing(const SearchSettings& settings, const SearchSpace& space)
    : settings_(settings), space_(space) {
  const int population = std::min(settings.population, settings.evaluations);
  slots_.assign(static_cast<std::size_t>(population), {{}, -std::numeric_limits<float>::infinity(), 0});
}

int PopulationHillClimbing::Budget(int slot) const {
  return settings_.evaluations / Population() + (slot < settings_.evaluations % Population() ? 1 : 0);
}

int PopulationHillClimbing::Horizon(int slot) const {
  // Generation 0 is the random start. Reseeding r follows generation r * interval.
  const std::int64_t next_reseed = (std::int64_t{reseedings_} + 1) * settings_.reseed_interval + 1;
  return static_cast<int>(std::min<std::int64_t>(next_reseed, Budget(slot)));
}

Genome PopulationHillClimbing::Propose(int slot, int proposal) const {
  if (proposal == 0) return FirstGenome(space_, settings_.variation, settings_.seed, slot);
  RandomStream random(settings_.seed, static_cast<std::uint64_t>(slot), static_cast<std::uint64_t>(proposal));
  return Perturb(slots_[static_cast<std::size_t>(slot)].genome, space_.shape, space_.senses,
                 settings_.variation, random);
}

std::vector<Genome> PopulationHillClimbing::Ask(int wanted) {
  // The climbs that wait for no score, those with the fewest generations first.
  std::vector<std::size_t> free;
  for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
    const auto is_slot = [&](const Asked& asked) { return asked.slot == slot; };
    if (std::ranges::none_of(asks_, [&](const auto& ask) { return std::ranges::any_of(ask, is_slot); })) {
      free.push_back(slot);
    }
  }
  std::ranges::sort(free, {}, [&](std::size_t slot) { return std::pair(slots_[slot].generation, slot); });
  const int ahead = wanted <= Population() ? 1 : std::max(kMinAhead, wanted / Population());
  std::vector<Genome> genomes;
  std::vector<Asked> ask;
  for (const std::size_t slot : free) {
    if (static_cast<int>(genomes.size()) >= wanted) break;
    const int first = slots_[slot].generation;
    // Nothing can be perturbed before the random start is scored.
    const int count = first == 0 ? 1 : std::clamp(Horizon(static_cast<int>(slot)) - first, 0, ahead);
    if (count == 0) continue;
    ask.push_back({slot, count});
    for (int k = 0; k < count; ++k) genomes.push_back(Propose(static_cast<int>(slot), first + k));
  }
  if (!ask.empty()) asks_.push_back(std::move(ask));
  return genomes;
}

void PopulationHillClimbing::Tell(std::span<const Score> scores) {
  if (asks_.empty()) return;
  std::size_t at = 0;
  const std::vector<Asked> scored = std::move(asks_.front());
  asks_.erase(asks_.begin());
  for (const auto& [i, count] : scored) {
    Slot& s = slots_[i];
    const int slot = static_cast<int>(i);
    const auto results = scores.subspan(at, static_cast<std::size_t>(count));
    at += results.size();
    for (const Score& score : results) {
      const int proposal = s.generation;
      const bool better = score.fitness > s.fitness;
      if (better || proposal == 0) {
        s.genome = Propose(slot, proposal);
        if (better) s.fitness = score.fitness;
        curve_.Add(proposal * Population() + slot + 1, s.fitness);
      }
      ++s.generation;
      if (better) break;
    }
  }
  curve_.SettleTo(Evaluations());
  ReseedIfDue();
}

void PopulationHillClimbing::ReseedIfDue() {
  const int due = (reseedings_ + 1) * settings_.reseed_interval + 1;
  if (!std::ranges::all_of(slots_, [&](const Slot& s) { return s.generation == due; })) return;
  // Rank by fitness. Ties keep the order of their slots.
  std::vector<std::size_t> rank(slots_.size());
  std::iota(rank.begin(), rank.end(), std::size_t{0});
  std::ranges::sort(rank, [&](std::size_t a, std::size_t b) {
    return slots_[a].fitness > slots_[b].fitness || (slots_[a].fitness == slots_[b].fitness && a < b);
  });
  const std::size_t half = slots_.size() / 2;
  for (std::size_t r = slots_.size() - half; r < slots_.size(); ++r) {
    slots_[rank[r]].genome = slots_[rank[r - (slots_.size() - half)]].genome;
    slots_[rank[r]].fitness = slots_[rank[r - (slots_.size() - half)]].fitness;
  }
  ++reseedings_;
}

int PopulationHillClimbing::Evaluations() const {
  // The serial loop visits slot after slot, generation after generation, so it has reached the first gap.
  int first_gap = settings_.evaluations;
  for (int slot = 0; slot < Population(); ++slot) {
    const int done = slots_[static_cast<std::size_t>(slot)].generation;
    if (done < Budget(slot)) first_gap = std::min(first_gap, done * Population() + slot);
  }
  return first_gap;
}

bool PopulationHillClimbing::Done() const { return Evaluations() >= settings_.evaluations; }

const PopulationHillClimbing::Slot& PopulationHillClimbing::Best() const {
  return *std::ranges::max_element(slots_,
                                   [](const Slot& a, const Slot& b) { return a.fitness < b.fitness; });
}
const Genome& PopulationHillClimbing::BestGenome() const { return Best().genome; }
float PopulationHillClimbing::BestFitness() const { return Best().fitness; }

std::vector<float> PopulationHillClimbing::PopulationFitness() const {
  std::vector<float> fitness;
  for (const Slot& slot : slots_) {
    if (slot.generation > 0) fitness.push_back(slot.fitness);
  }
  return fitness;
}

void PopulationHillClimbing::Save(BitWriter& out) const {
  out.Put(static_cast<std::uint32_t>(reseedings_), 32);
  for (const Slot& slot : slots_) {
    PutGenome(out, slot.genome, slot.fitness);
    out.Put(static_cast<std::uint32_t>(slot.generation), 32);
  }
  curve_.Save(out);
}

Result<void> PopulationHillClimbing::Load(BitReader& in) {
  PopulationHillClimbing read(settings_, space_);
  const auto reseedings = static_cast<std::int64_t>(in.Take(32));
  if (reseedings > settings_.evaluations / Population() / settings_.reseed_interval) {
    return Fail(ErrorCode::kOutOfRange, "search.reseedings", "does not fit the budget");
  }
  read.reseedings_ = static_cast<int>(reseedings);
  for (int slot = 0; slot < Population(); ++slot) {
    Slot& s = read.slots_[static_cast<std::size_t>(slot)];
    const bool good = TakeGenome(in, s.genome, s.fitness, space_.shape.Genes());
    const auto generation = static_cast<std::int64_t>(in.Take(32));
    if (in.Overrun()) return Fail(ErrorCode::kTruncated, "search", "the saved search ends too early");
    if (!good || generation > read.Horizon(slot) || (generation > 0) == s.genome.empty()) {
      return Fail(ErrorCode::kOutOfRange, "search.slots[" + std::to_string(slot) + "]",
                  "is not a state of this search");
    }
    s.generation = static_cast<int>(generation);
  }
  read.curve_.Load(in);
  if (in.Overrun()) return Fail(ErrorCode::kTruncated, "search", "the saved search ends too early");
  if (!in.AtEnd()) return Fail(ErrorCode::kTrailing, "search", "the saved search has data after its end");
  *this = std::move(read);
  return {};
}

std::unique_ptr<Search> MakeSphc(const SearchSettings& settings, const SearchSpace& space) {
  return std::make_unique<PopulationHillClimbing>(settings, space);
}

std::unique_ptr<Search> MakeShc(const SearchSettings& settings, const SearchSpace& space) {
  // Figure 4 is Figure 5 with one individual, without reseeding.
  SearchSettings alone = settings;
  alone.population = 1;
  return std::make_unique<PopulationHillClimbing>(alone, space);
}

}  // namespace gaitsmith
