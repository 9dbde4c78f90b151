// SPDX-License-Identifier: MIT
// What a bank of rules sensed during its own motion, for searches that place rules where the figure really
// passes.
#pragma once

#include <vector>

#include "core/control/sighting.h"
#include "core/rollout/problem.h"

namespace gaitsmith {

/// Simulates a bank once for the task's duration, from the first of the problem's beginnings.
/// @param genes of the problem's shape
/// @param count number of sightings, evenly spaced, the last one at the end; at least 1
/// @return empty for a network, which has no rules
[[nodiscard]] std::vector<Sighting> SightingsOf(const Problem& problem, const Genome& genes, int count);

}  // namespace gaitsmith
