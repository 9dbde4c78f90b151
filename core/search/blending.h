// SPDX-License-Identifier: MIT
// Operators on genes as real numbers, which evolutionary computation uses where a genome is a point and not a
// set of rules.
#pragma once

#include "core/control/controller.h"
#include "core/numeric/random.h"

namespace gaitsmith {

/// The gene nearest to a share of its range, within the range. NaN becomes 0, like any value below it.
[[nodiscard]] Gene GeneAt(double share);

/// Simulated binary crossover within bounds [Deb Agrawal 1995] of the genes of two genomes of one shape, in
/// place. Each gene is blended with a chance of one half.
void Blend(Genome& first, Genome& second, RandomStream&);

/// Polynomial mutation within bounds [Deb Goyal 1996] of each gene with a chance. @param chance [0, 1]
void Move(Genome&, double chance, RandomStream&);

}  // namespace gaitsmith
