// SPDX-License-Identifier: MIT
// How well the selected clip takes over: at its present start and, as a map that the host computes, at other
// moments. The map restarts shortly after a change of anything but the clip's own start, and pauses while a
// search changes the motion.
#pragma once

#include <optional>

#include "shell/results/search_run.h"
#include "shell/session/transition_scores.h"
#include "shell/workspace/workspace.h"

namespace gaitsmith::shell {

class TransitionRun {
 public:
  TransitionRun(Workspace& workspace, const SearchRun& search) : workspace_(workspace), search_(search) {}

  /// The share at the moment of the map that is nearest to the selected clip's start; nothing if it is not
  /// known.
  [[nodiscard]] std::optional<float> ShareAtStart() const;
  [[nodiscard]] const TransitionScores& Scores() const { return scores_; }

  /// Call after each change of the document or the selection: forgets the old map and starts a new one if
  /// needed.
  void Follow();
  /// Call once a frame. @param seconds since the last call
  void Advance(double seconds);
  void OnScores(const TransitionPart& part) { scores_.Take(part); }
  void OnFailed(int generation);

 private:
  Workspace& workspace_;
  const SearchRun& search_;
  TransitionScores scores_;
  double unchanged_for_s_ = 0.0;  // age of the last change [s]
};

}  // namespace gaitsmith::shell
