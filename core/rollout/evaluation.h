// SPDX-License-Identifier: MIT
// What a motion was worth.
#pragma once

#include <cstdint>

#include "core/rollout/task.h"

namespace gaitsmith {

struct Evaluation {
  float fitness = kVoidScore;         // with several beginnings: the mean, void if one is
  Terms terms;                        // means, too; further ones only where the task weighs them
  std::uint64_t trajectory_hash = 0;  // only filled when asked for
};

/// Takes one more of several evaluations into their mean. @param before how many are in it
void AddToMean(Evaluation& mean, const Evaluation& next, int before);

}  // namespace gaitsmith
