// SPDX-License-Identifier: MIT
// The document's plan at work: it is carried out again shortly after each change, in the background. The
// motion relaxes as a second one on the stage meanwhile; what the simulator makes of it replaces the motion.
#pragma once

#include <string>

#include "core/planning/planning.h"
#include "shell/results/search_run.h"
#include "shell/session/motion_comparison.h"
#include "shell/workspace/workspace.h"

namespace gaitsmith::shell {

class PlanRun {
 public:
  PlanRun(Workspace& workspace, const SearchRun& search, MotionComparison& comparison)
      : workspace_(workspace), search_(search), comparison_(comparison) {}

  enum class State {
    kNone,        // there is no plan
    kKept,        // a solved plan was opened
    kWaits,       // it is carried out in a moment
    kWorks,       // a motion relaxes, or is refined
    kDone,        // planned and played
    kRefused,     // something cannot be met
    kImpossible,  // the document cannot be planned at all
    kFailed,      // the worker died
  };
  [[nodiscard]] State Now() const { return state_; }
  /// How it stands, in a sentence.
  [[nodiscard]] std::string Words() const;
  /// What cannot be met the most; null unless refused.
  [[nodiscard]] const PlanMiss* Culprit() const;
  [[nodiscard]] bool Working() const { return state_ == State::kWaits || state_ == State::kWorks; }

  /// Call after each change of the document. @param opened another document replaced the present one
  void Follow(bool opened);
  /// Call once a frame. @param seconds since the last call
  void Advance(double seconds);
  /// Carries the plan out once more.
  void Again();
  /// Gives up what is under way.
  void Stop();

  /// Called by the host. Reports of earlier generations are ignored.
  void OnReport(int generation, PlanReport report);
  /// The worker died, or cannot be started.
  void OnFailed(int generation);

 private:
  /// Whether two documents have the same plan for the same body in the same world.
  [[nodiscard]] static bool SamePlan(const Document&, const Document&);
  void Wait();

  Workspace& workspace_;
  const SearchRun& search_;
  MotionComparison& comparison_;
  State state_ = State::kNone;
  Document asked_;     // whose plan it is
  Document settled_;   // the last one whose solution is of its own plan
  PlanReport report_;  // the last one
  std::string fault_;  // why it is impossible
  int generation_ = 0;
  bool fine_ = false;  // the motion is found, and being played
  double unchanged_for_s_ = 0.0;
};

}  // namespace gaitsmith::shell
