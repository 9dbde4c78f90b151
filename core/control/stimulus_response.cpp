// SPDX-License-Identifier: MIT
#include "core/control/stimulus_response.h"

#include <algorithm>

#include "core/numeric/scalar_math.h"

namespace gaitsmith {

float DecodeTau(Gene gene, const SenseSpec& senses) {
  const double span = Log(static_cast<double>(senses.tau_max_s) / static_cast<double>(senses.tau_min_s));
  return static_cast<float>(static_cast<double>(senses.tau_min_s) * Exp(span * gene / kGeneMax));
}

namespace {

/// Share of hits on a stimulus interval that redraw it, or whether it is cared about, instead of moving its
/// ends.
constexpr double kRedrawCare = 0.25;

void DrawInterval(Gene& low, Gene& high, RandomStream& random) {
  low = random.Gene();
  high = random.Gene();
  if (low > high) std::swap(low, high);
}

void DrawRule(std::span<Gene> genes, const BankShape& shape, int rule, const SenseSpec& senses,
              const Variation& variation, RandomStream& random) {
  for (int sense = 0; sense < shape.senses; ++sense) {
    Gene& low = genes[shape.Low(rule, sense)];
    Gene& high = genes[shape.High(rule, sense)];
    if (senses.kind == SenseKind::kPhysical && random.Chance(static_cast<double>(variation.dont_care))) {
      low = 0;
      high = kGeneMax;
    } else {
      DrawInterval(low, high, random);
    }
  }
  for (int joint = 0; joint < shape.joints; ++joint) genes[shape.Target(rule, joint)] = random.Gene();
  genes[shape.Tau(rule)] = random.Gene();
}

Gene Creep(Gene gene, const Variation& variation, RandomStream& random) {
  const double moved = gene + random.Normal() * static_cast<double>(variation.creep) * kGeneMax;
  return static_cast<Gene>(std::clamp(moved + 0.5, 0.0, static_cast<double>(kGeneMax)));
}

void CreepRule(std::span<Gene> genes, const BankShape& shape, int rule, const SenseSpec& senses,
               const Variation& variation, RandomStream& random) {
  const auto hit = [&] { return random.Chance(static_cast<double>(variation.gene_chance)); };
  for (int sense = 0; sense < shape.senses; ++sense) {
    Gene& low = genes[shape.Low(rule, sense)];
    Gene& high = genes[shape.High(rule, sense)];
    const bool cares = low != 0 || high != kGeneMax;
    const bool hit_low = hit();
    const bool hit_high = hit();
    if (!hit_low && !hit_high) continue;
    // Whether a rule cares about a sense is itself heritable: a hit redraws it now and then, in the
    // proportion of the initial generation, so that banks do not drift into caring about everything.
    if (senses.kind == SenseKind::kPhysical && random.Chance(kRedrawCare)) {
      const bool ignore = random.Chance(static_cast<double>(variation.dont_care));
      if (ignore) {
        low = 0;
        high = kGeneMax;
      } else {
        DrawInterval(low, high, random);
      }
      continue;
    }
    if (!cares) continue;
    if (hit_low) low = Creep(low, variation, random);
    if (hit_high) high = Creep(high, variation, random);
    if (low > high) std::swap(low, high);
  }
  for (int joint = 0; joint < shape.joints; ++joint) {
    Gene& target = genes[shape.Target(rule, joint)];
    if (hit()) target = Creep(target, variation, random);
  }
  Gene& tau = genes[shape.Tau(rule)];
  if (hit()) tau = Creep(tau, variation, random);
}

}  // namespace

Genome RandomGenome(const BankShape& shape, const SenseSpec& senses, const Variation& variation,
                    RandomStream& random) {
  Genome genes(shape.Genes());
  for (int rule = 0; rule < shape.rules; ++rule) DrawRule(genes, shape, rule, senses, variation, random);
  return genes;
}

Genome Perturb(std::span<const Gene> parent, const BankShape& shape, const SenseSpec& senses,
               const Variation& variation, RandomStream& random) {
  Genome child(parent.begin(), parent.end());
  for (;;) {
    for (int rule = 0; rule < shape.rules; ++rule) {
      if (random.Chance(static_cast<double>(variation.redraw))) {
        DrawRule(child, shape, rule, senses, variation, random);
      } else {
        CreepRule(child, shape, rule, senses, variation, random);
      }
    }
    // A child equal to its parent would waste a simulation.
    if (!std::ranges::equal(child, parent)) return child;
  }
}

}  // namespace gaitsmith
