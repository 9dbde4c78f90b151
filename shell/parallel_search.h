// SPDX-License-Identifier: MIT
// Runs a search to its end on several threads. The threads only evaluate; what they evaluate, and in which
// order the results count, is the search's affair, so the outcome is the same for any number of threads.
#pragma once

#include <functional>

#include "core/physics/evaluator.h"
#include "core/search/search.h"

namespace gaitsmith::shell {

/// Cores of this machine, at least 1.
[[nodiscard]] int Cores();

/// @param threads [1, 256]
/// @param go_on   called after every batch, on the calling thread; false ends the run early, and the search
/// may be
///                handed in again later to continue
void RunSearch(Search& search, const Evaluator& evaluator, int threads,
               const std::function<bool(const Search&)>& go_on);

}  // namespace gaitsmith::shell
