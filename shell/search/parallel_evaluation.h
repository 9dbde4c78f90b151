// SPDX-License-Identifier: MIT
// Scores many genomes on several threads, for programs that hold them in memory of their own.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/rollout/evaluator.h"

namespace gaitsmith::shell {

/// @param genomes views of the caller's memory, each with Problem::Shape().Genes() genes; nothing is copied
/// @param threads >= 1; affects the time, never the results
/// @param stop    polled on the calling thread between pieces; true ends the evaluation early
/// @return an evaluation for each genome, in order; after a stop some are void
[[nodiscard]] std::vector<Evaluation> EvaluateInParallel(const Evaluator& evaluator,
                                                         std::span<const std::span<const Gene>> genomes,
                                                         int threads, const std::function<bool()>& stop);

}  // namespace gaitsmith::shell
