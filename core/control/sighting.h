// SPDX-License-Identifier: MIT
// What a bank of rules sensed at one step of a motion, and the rule that was active after it.
#pragma once

#include <vector>

#include "core/control/gene_groups.h"

namespace gaitsmith {

struct Sighting {
  int rule = 0;  // [0, rules)
  /// Each normalised sense on the grid of a stimulus's ends (EdgesOf), clamped to it (senses).
  std::vector<Gene> senses;
};

}  // namespace gaitsmith
