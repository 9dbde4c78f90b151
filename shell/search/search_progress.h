// SPDX-License-Identifier: MIT
// The progress of a search, as reported by a page's worker, the desktop's threads and the command line.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/rollout/task.h"
#include "core/search/search.h"
#include "core/search/spread.h"

namespace gaitsmith::shell {

enum class SearchState { kIdle, kRunning, kPaused, kDone, kStopped, kFailed };
/// In the order of SearchState.
inline constexpr std::array<std::string_view, 6> kSearchStateNames = {"idle", "running", "paused",
                                                                      "done", "stopped", "failed"};

/// Reported at most about thirty times a second, and once at the end.
struct SearchProgress {
  SearchState state = SearchState::kIdle;
  int evaluations = 0;
  int budget = 0;
  double evaluations_per_second = 0.0;
  double seconds_left = 0.0;
  int workers = 0;
  float best_fitness = kVoidScore;
  std::vector<Search::CurvePoint> curve = {};
  Genome best_genome = {};               // empty: as in the last report, or none yet
  Genome attempt = {};                   // one that was simulated since the last report; empty: none
  std::optional<Spread> spread = {};     // of the present population
  std::vector<std::uint8_t> saved = {};  // state of the whole search (Search::Save), only in the last report

  /// Share of the budget that is spent, [0, 1].
  [[nodiscard]] float Share() const {
    return budget > 0 ? std::clamp(static_cast<float>(evaluations) / static_cast<float>(budget), 0.0f, 1.0f)
                      : 0.0f;
  }
};

}  // namespace gaitsmith::shell
