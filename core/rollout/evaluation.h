// SPDX-License-Identifier: MIT
// The score of a motion.
#pragma once

#include <cstdint>

#include "core/rollout/task.h"
#include "core/signal/traits.h"

namespace gaitsmith {

struct Evaluation {
  float fitness = kVoidScore;  // with several beginnings: the mean, void if one is void
  Terms terms;                 // means over the beginnings; further terms only if the task weights them
  std::uint64_t trajectory_hash = 0;  // only filled on request
  Traits traits{};                    // only if the problem asks for them; means over the beginnings
};

/// Adds an evaluation to the mean of several. @param before number of evaluations already in the mean
void AddToMean(Evaluation& mean, const Evaluation& next, int before);

}  // namespace gaitsmith
