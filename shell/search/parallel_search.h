// SPDX-License-Identifier: MIT
// Runs a search to its end on several threads, for the desktop window and the command line. The result is the
// same for any number of threads, since core's searches do not depend on how their batches are cut.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>

#include "core/search/evaluation_score.h"
#include "shell/search/search_progress.h"

namespace gaitsmith::shell {

/// Lets another thread pause and cancel a running search.
class SearchControl {
 public:
  void Pause(bool paused);
  void Cancel();
  [[nodiscard]] bool Cancelled() const;
  [[nodiscard]] bool Paused() const;
  /// Blocks while paused. @return false once cancelled
  bool Proceed();

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool paused_ = false;
  bool cancelled_ = false;
};

/// Cores of this machine, at least 1.
[[nodiscard]] int Cores();

/// Runs a search that was made by hand.
/// @param budget    its evaluations
SearchProgress RunToEnd(const Scorer& scorer, Search& search, int budget, int threads, SearchControl& control,
                        const std::function<void(const SearchProgress&)>& report);

/// @param problem   valid
/// @param threads   >= 1
/// @param report    called on the calling thread, between batches
/// @param start     SearchSpace::start
/// @return the last report: kDone with the whole budget spent, or kStopped after Cancel
SearchProgress RunParallelSearch(const Problem& problem, const SearchSettings& settings, int threads,
                                 SearchControl& control,
                                 const std::function<void(const SearchProgress&)>& report,
                                 const Genome& start = {});

}  // namespace gaitsmith::shell
