// SPDX-License-Identifier: MIT
// The worlds in which a search for robust controllers tries each genome: all a little different from the
// document's. As [Jakobi 1995] has it, noise keeps evolution from relying on what a simulator
// only happens to do.
#pragma once

#include <cstdint>
#include <vector>

#include "core/rollout/problem.h"

namespace gaitsmith {

inline constexpr int kMaxWorlds = 16;
inline constexpr int kRobustWorlds = 5;  // of what is made robust with one command

/// How far trial worlds are from the document's, in both directions where that makes sense.
struct WorldNoise {
  double friction = 0.4;    // share of the coefficient
  double mass = 0.2;        // share of the mass of each rod or node
  double slope_rad = 0.02;  // about one degree
  int delay_steps = 3;      // at most
  int halvings = 0;         // of the time step, at most; worlds take them in turn, the most first
};

/// @param seed of the search @param worlds with the document's own, [1, kMaxWorlds] @param parts with a mass
/// @return all but the document's own, each with every noise at once
[[nodiscard]] std::vector<TrialWorld> DrawWorlds(std::uint32_t seed, int worlds, int parts,
                                                 const WorldNoise& noise = {});

}  // namespace gaitsmith
