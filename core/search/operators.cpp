// SPDX-License-Identifier: MIT
#include "core/search/operators.h"

#include <algorithm>
#include <cstdint>

#include "core/search/blending.h"

namespace gaitsmith {

namespace {

/// Share of mutations of a stimulus interval that redraw it, or whether its sense is used, instead of moving
/// its ends.
constexpr double kRedrawCare = 0.25;

void DrawInterval(Gene& low, Gene& high, RandomStream& random) {
  low = random.Gene();
  high = random.Gene();
  if (low > high) std::swap(low, high);
}

/// Draws whether a sense is used, then the interval.
void DrawStimulus(Gene& low, Gene& high, const SenseSpec& senses, const Variation& variation,
                  RandomStream& random) {
  if (senses.kind != SenseKind::kTimer && random.Chance(static_cast<double>(variation.dont_care))) {
    low = 0;
    high = kGeneMax;
  } else {
    DrawInterval(low, high, random);
  }
}

Gene Creep(Gene gene, const Variation& variation, RandomStream& random) {
  const double moved = gene + random.Normal() * static_cast<double>(variation.creep) * kGeneMax;
  return static_cast<Gene>(std::clamp(moved + 0.5, 0.0, static_cast<double>(kGeneMax)));
}

void CreepStimulus(Gene& low, Gene& high, const SenseSpec& senses, const Variation& variation,
                   RandomStream& random) {
  const auto hit = [&] { return random.Chance(static_cast<double>(variation.gene_chance)); };
  const bool cares = Cares(low, high);
  const bool hit_low = hit();
  const bool hit_high = hit();
  if (!hit_low && !hit_high) return;
  // Whether a rule uses a sense is heritable too. Some mutations redraw it, with the probability of the
  // initial generation, so that banks do not drift towards using every sense.
  if (senses.kind != SenseKind::kTimer && random.Chance(kRedrawCare)) {
    return DrawStimulus(low, high, senses, variation, random);
  }
  if (!cares) return;
  if (hit_low) low = Creep(low, variation, random);
  if (hit_high) high = Creep(high, variation, random);
  if (low > high) std::swap(low, high);
}

/// Lets a component that ignores every sense use a random one, if it must use one.
void Heed(Genome& genes, const ControllerShape& shape, int component, const SenseSpec& senses,
          const Variation& variation, RandomStream& random) {
  if (variation.heedless == Heedless::kAllowed || senses.kind == SenseKind::kTimer) return;
  for (const GeneGroup& group : shape.GroupsOf(component)) {
    if (group.role != GeneRole::kIntervals) continue;
    const std::span<Gene> ends = group.Of(genes);
    for (std::size_t i = 0; i < ends.size(); i += 2) {
      if (Cares(ends[i], ends[i + 1])) return;
    }
    if (ends.empty()) return;
    const std::size_t sense = random.Below(static_cast<std::uint32_t>(ends.size() / 2));
    Gene &low = ends[2 * sense], &high = ends[2 * sense + 1];
    while (!Cares(low, high)) DrawInterval(low, high, random);
  }
}

void DrawComponent(Genome& genes, const ControllerShape& shape, int component, const SenseSpec& senses,
                   const Variation& variation, RandomStream& random) {
  for (const GeneGroup& group : shape.GroupsOf(component)) {
    const std::span<Gene> drawn = group.Of(genes);
    if (group.role == GeneRole::kIntervals) {
      for (std::size_t i = 0; i < drawn.size(); i += 2)
        DrawStimulus(drawn[i], drawn[i + 1], senses, variation, random);
    } else {
      for (Gene& gene : drawn) gene = random.Gene();
    }
  }
  Heed(genes, shape, component, senses, variation, random);
}

void CreepComponent(Genome& genes, const ControllerShape& shape, int component, const SenseSpec& senses,
                    const Variation& variation, RandomStream& random) {
  for (const GeneGroup& group : shape.GroupsOf(component)) {
    const std::span<Gene> moved = group.Of(genes);
    if (group.role == GeneRole::kIntervals) {
      for (std::size_t i = 0; i < moved.size(); i += 2)
        CreepStimulus(moved[i], moved[i + 1], senses, variation, random);
      continue;
    }
    for (Gene& gene : moved) {
      if (random.Chance(static_cast<double>(variation.gene_chance))) gene = Creep(gene, variation, random);
    }
  }
  Heed(genes, shape, component, senses, variation, random);
}

/// Mutates a controller once. The result may equal the parent.
void PerturbOnce(Genome& child, const ControllerShape& shape, const SenseSpec& senses,
                 const Variation& variation, RandomStream& random) {
  for (int component = 0; component < shape.Components(); ++component) {
    if (random.Chance(static_cast<double>(variation.redraw))) {
      DrawComponent(child, shape, component, senses, variation, random);
    } else {
      CreepComponent(child, shape, component, senses, variation, random);
    }
  }
}

void OrderIntervals(Genome& genes, const ControllerShape& shape) {
  shape.ForEachInterval([&](std::size_t low) {
    if (genes[low] > genes[low + 1]) std::swap(genes[low], genes[low + 1]);
  });
}

}  // namespace

Genome RandomGenome(const ControllerShape& shape, const SenseSpec& senses, const Variation& variation,
                    RandomStream& random) {
  Genome genes(shape.Genes());
  for (int component = 0; component < shape.Components(); ++component) {
    DrawComponent(genes, shape, component, senses, variation, random);
  }
  return genes;
}

Genome Perturb(std::span<const Gene> parent, const ControllerShape& shape, const SenseSpec& senses,
               const Variation& variation, RandomStream& random) {
  Genome child(parent.begin(), parent.end());
  for (;;) {
    PerturbOnce(child, shape, senses, variation, random);
    // A child equal to its parent would waste a simulation.
    if (!std::ranges::equal(child, parent)) return child;
  }
}

Genome FirstGenome(const SearchSpace& space, const Variation& variation, std::uint32_t seed, int individual) {
  if (individual == 0 && !space.start.empty()) return space.start;
  RandomStream random(seed, static_cast<std::uint64_t>(individual), 0);
  return RandomGenome(space.shape, space.senses, variation, random);
}

Genome Cross(std::span<const Gene> first, std::span<const Gene> second, const ControllerShape& shape,
             const Rates& rates, RandomStream& random) {
  Genome child(second.begin(), second.end());
  const bool per_child = rates.reading == RateReading::kPerChild;
  const auto rate = static_cast<double>(rates.crossover);
  if (per_child && !random.Chance(rate)) return child;
  const double from_first = per_child ? 0.5 : rate;
  for (int component = 0; component < shape.Components(); ++component) {
    const std::size_t at = shape.Begin(component);
    if (random.Chance(from_first)) {
      std::ranges::copy(first.subspan(at, shape.Begin(component + 1) - at), &child[at]);
    }
  }
  return child;
}

void Mutate(Genome& child, const SearchSpace& space, const Variation& variation, const Rates& rates,
            RandomStream& random) {
  if (rates.reading == RateReading::kPerChild) {
    if (!random.Chance(static_cast<double>(rates.mutation))) return;
    child = Perturb(child, space.shape, space.senses, variation, random);
    return;
  }
  Variation per_gene = variation;
  per_gene.gene_chance = rates.mutation;
  per_gene.redraw = std::min(1.0f, variation.redraw * (rates.mutation / variation.gene_chance));
  PerturbOnce(child, space.shape, space.senses, per_gene, random);
}

void PerturbCopy(Genome& child, std::span<const Gene> first, std::span<const Gene> second,
                 const SearchSpace& space, const Variation& variation, const Rates& rates,
                 RandomStream& random) {
  if (rates.copies == Copies::kKept) return;
  if (std::ranges::equal(child, first) || std::ranges::equal(child, second)) {
    child = Perturb(child, space.shape, space.senses, variation, random);
  }
}

Offspring Breed(std::span<const Gene> first, std::span<const Gene> second, const SearchSpace& space,
                const Variation& variation, const Rates& rates, RandomStream& random) {
  if (rates.crossing == Crossing::kBlended) {
    Offspring blended = {Genome(first.begin(), first.end()), Genome(second.begin(), second.end())};
    if (random.Chance(static_cast<double>(rates.crossover))) Blend(blended.copy, blended.hybrid, random);
    for (Genome* child : {&blended.copy, &blended.hybrid}) {
      Move(*child, static_cast<double>(rates.mutation), random);
      OrderIntervals(*child, space.shape);
      PerturbCopy(*child, first, second, space, variation, rates, random);
    }
    return blended;
  }
  Offspring children = {Genome(first.begin(), first.end()), Cross(first, second, space.shape, rates, random)};
  for (Genome* child : {&children.copy, &children.hybrid}) {
    Mutate(*child, space, variation, rates, random);
    PerturbCopy(*child, first, second, space, variation, rates, random);
  }
  return children;
}

double GeneDistance(std::span<const Gene> first, std::span<const Gene> second) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    sum += static_cast<std::uint64_t>(std::max(first[i], second[i]) - std::min(first[i], second[i]));
  }
  return first.empty() ? 0.0 : static_cast<double>(sum) / (static_cast<double>(first.size()) * kGeneMax);
}

std::vector<double> PointOf(std::span<const Gene> genome) {
  std::vector<double> point;
  point.reserve(genome.size());
  for (const Gene gene : genome) point.push_back(gene * (1.0 / kGeneMax));
  return point;
}

Genome GenomeAt(std::span<const double> point, const ControllerShape& shape) {
  Genome genome;
  genome.reserve(point.size());
  for (const double x : point) genome.push_back(GeneAt(x));
  OrderIntervals(genome, shape);
  return genome;
}

}  // namespace gaitsmith
