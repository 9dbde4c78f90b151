// SPDX-License-Identifier: MIT
#include "core/search/population_hill_climbing.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/search/genome_bits.h"

namespace gaitsmith {

PopulationHillClimbing::PopulationHillClimbing(const SearchSettings& settings, const SearchSpace& space)
    : settings_(settings), space_(space) {
  const int population = std::min(settings.population, settings.evaluations);
  slots_.assign(static_cast<std::size_t>(population), {{}, -std::numeric_limits<float>::infinity(), 0});
  asked_.assign(slots_.size(), 0);
}

int PopulationHillClimbing::Budget(int slot) const {
  return settings_.evaluations / Population() + (slot < settings_.evaluations % Population() ? 1 : 0);
}

int PopulationHillClimbing::Horizon(int slot) const {
  // Generation 0 is the random start; the reseeding numbered r follows generation r * interval.
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
  std::vector<Genome> asked;
  const int ahead = std::max(1, wanted / Population());
  for (int slot = 0; slot < Population(); ++slot) {
    const auto i = static_cast<std::size_t>(slot);
    const int first = slots_[i].generation;
    // Nothing can be perturbed before the random start is known.
    asked_[i] = first == 0 ? 1 : std::clamp(Horizon(slot) - first, 0, ahead);
    for (int k = 0; k < asked_[i]; ++k) asked.push_back(Propose(slot, first + k));
  }
  return asked;
}

void PopulationHillClimbing::Tell(std::span<const Score> scores) {
  std::size_t at = 0;
  for (int slot = 0; slot < Population(); ++slot) {
    const auto i = static_cast<std::size_t>(slot);
    Slot& s = slots_[i];
    const auto results = scores.subspan(at, static_cast<std::size_t>(asked_[i]));
    at += results.size();
    for (const auto& [value, style] : results) {
      const int proposal = s.generation;
      const bool better = value > s.fitness;
      if (better || proposal == 0) {
        s.genome = Propose(slot, proposal);
        if (better) s.fitness = value;
        curve_.Add(proposal * Population() + slot + 1, s.fitness);
      }
      ++s.generation;
      if (better) break;
    }
  }
  asked_.assign(asked_.size(), 0);
  curve_.SettleTo(Evaluations());
  ReseedIfDue();
}

void PopulationHillClimbing::ReseedIfDue() {
  const int due = (reseedings_ + 1) * settings_.reseed_interval + 1;
  if (!std::ranges::all_of(slots_, [&](const Slot& s) { return s.generation == due; })) return;
  // Rank by fitness; equals keep the order of their slots.
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
  // The serial loop visits slot after slot, generation after generation: it has come as far as the first gap.
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
  if (!in.AtEnd()) return Fail(ErrorCode::kTrailing, "search", "the saved search goes on after its end");
  *this = std::move(read);
  return {};
}

}  // namespace gaitsmith
