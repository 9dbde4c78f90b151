// SPDX-License-Identifier: MIT
#include "core/search/blending.h"

#include <algorithm>

#include "core/numeric/scalar_math.h"

namespace gaitsmith {

namespace {

/// How close blended children stay to their parents, and mutated genes to what they were: the usual numbers.
constexpr double kBlendIndex = 10.0, kMoveIndex = 50.0;

double RaisedTo(double base, double exponent) { return base > 0.0 ? Exp(exponent * Log(base)) : 0.0; }

}  // namespace

Gene GeneAt(double share) {
  const double within = share > 0.0 ? std::min(share, 1.0) : 0.0;
  const double nearest = within * kGeneMax + 0.5;  // rounded down
  return static_cast<Gene>(nearest);
}

void Blend(Genome& first, Genome& second, RandomStream& random) {
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == second[i] || !random.Chance(0.5)) continue;
    const double low = std::min(first[i], second[i]) * (1.0 / kGeneMax);
    const double high = std::max(first[i], second[i]) * (1.0 / kGeneMax);
    const double u = random.Uniform();
    // How far a child lies from the middle, in half the parents' distance, if `free` is left on its side.
    const auto spread = [&](double free) {
      const double alpha = 2.0 - RaisedTo(1.0 + 2.0 * free / (high - low), -(kBlendIndex + 1.0));
      const double within = u * alpha <= 1.0 ? u * alpha : 1.0 / (2.0 - u * alpha);
      return RaisedTo(within, 1.0 / (kBlendIndex + 1.0));
    };
    const double middle = (low + high) / 2.0, half = (high - low) / 2.0;
    const Gene lower = GeneAt(middle - half * spread(low)),
               upper = GeneAt(middle + half * spread(1.0 - high));
    const bool swapped = random.Chance(0.5);
    first[i] = swapped ? upper : lower;
    second[i] = swapped ? lower : upper;
  }
}

void Move(Genome& genes, double chance, RandomStream& random) {
  for (Gene& gene : genes) {
    if (!random.Chance(chance)) continue;
    const double at = gene * (1.0 / kGeneMax);
    const double u = random.Uniform();
    const double power = 1.0 / (kMoveIndex + 1.0);
    const double moved =
        u < 0.5 ? RaisedTo(2.0 * u + (1.0 - 2.0 * u) * RaisedTo(1.0 - at, kMoveIndex + 1.0), power) - 1.0
                : 1.0 - RaisedTo(2.0 * (1.0 - u) + (2.0 * u - 1.0) * RaisedTo(at, kMoveIndex + 1.0), power);
    gene = GeneAt(at + moved);
  }
}

}  // namespace gaitsmith
