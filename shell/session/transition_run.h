// SPDX-License-Identifier: MIT
// How well the selected clip takes over: where it does now, and, as a map that the host works out, where it
// could. The map begins anew, a moment after the last change, when something else than the clip's own
// beginning has changed, and waits while a search changes the motion.
#pragma once

#include <cstdint>
#include <optional>

#include "core/document/transition.h"
#include "shell/session/search_run.h"
#include "shell/session/transition_scores.h"
#include "shell/session/workspace.h"

namespace gaitsmith::shell {

class TransitionRun {
 public:
  TransitionRun(Workspace& workspace, const SearchRun& search) : workspace_(workspace), search_(search) {}

  /// How near the figure is to the usual motion of the selected clip's controller when that takes over;
  /// nothing for the first clip.
  [[nodiscard]] std::optional<Nearness> NearnessAtHandover();
  [[nodiscard]] const TransitionScores& Scores() const { return scores_; }

  /// After each change of the document or of the selection: another map is begun, and the old one forgotten.
  void Follow();
  /// Once a frame. @param seconds since the last one
  void Advance(double seconds);
  void OnScores(const TransitionPart& part) { scores_.Take(part); }
  void OnFailed(int generation);

 private:
  struct KnownNearness {
    std::uint64_t hash = 0;  // of the motion
    int clip = 0;
    Nearness nearness;
  };

  Workspace& workspace_;
  const SearchRun& search_;
  TransitionScores scores_;
  double unchanged_for_s_ = 0.0;  // the map that is wanted
  KnownNearness nearness_;        // what was worked out last
};

}  // namespace gaitsmith::shell
