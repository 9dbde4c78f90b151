// SPDX-License-Identifier: MIT
// The timeline: the clips that are chained into one motion, the selected one of them, and its controller.
// What cannot be done is said, and changes nothing. Lengths travel with their clips.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/numeric/error.h"
#include "shell/session/motion_comparison.h"
#include "shell/session/result_store.h"
#include "shell/session/search_run.h"
#include "shell/session/transition_run.h"
#include "shell/session/workspace.h"

namespace gaitsmith::shell {

class TimelineEditor {
 public:
  TimelineEditor(Workspace& workspace, SearchRun& search, MotionComparison& comparison,
                 const ResultStore& results)
      : workspace_(workspace),
        search_(search),
        comparison_(comparison),
        results_(results),
        transitions_(workspace, search) {}

  /// One clip is selected: its controller is shown, and a search replaces it.
  [[nodiscard]] int Selected() const { return workspace_.SelectedClip(); }
  /// @param clip any number: the nearest clip is selected
  void Select(int clip) { workspace_.SelectClip(clip); }
  /// Null: there is no motion.
  [[nodiscard]] const Controller* ShownController() const { return workspace_.ShownController(); }
  /// Changes the shown controller in place, by hand: its name says so from then on, a search that would
  /// replace it ends, and settings of the next search that were this controller's number of rules stay so.
  bool ChangeController(const std::function<void(Controller&)>& edit);

  /// The selected clip once more, at the end.
  void AddClip();
  void RemoveClip();
  /// Moves the border before a clip; clips behind it stay where they are. @param start_step [0, kMaxSteps)
  void MoveClip(int clip, int start_step);
  /// @param steps at least kShortestClip
  void SetClipLength(int clip, int steps);
  /// Cuts the clip in charge at the moment that is shown.
  void SplitClip();
  void DuplicateClip();
  /// The selected clip goes the other way.
  void MirrorClip();
  /// The selected clip goes to this place among all.
  void ReorderClip(int to);
  /// The whole timeline once more behind itself.
  void Repeat();
  /// A found motion takes over at the moment that is shown, all its clips.
  /// @param step  or there instead
  /// @return false: there is no such motion, or it does not fit
  bool InsertFound(const std::string& id, std::optional<int> step = {});
  /// A short search makes the selected clip's controller better.
  void RepairClip() { search_.ImproveClip(); }
  [[nodiscard]] bool CanRepair() const { return search_.CanImproveClip(); }
  /// Task, senses and length of the motion belong together while there is only one clip.
  /// @param steps [1, kMaxSteps]
  void SetDuration(int steps);

  /// Where the selected clip takes over, and where it could.
  [[nodiscard]] TransitionRun& Transitions() { return transitions_; }
  [[nodiscard]] const TransitionRun& Transitions() const { return transitions_; }
  /// The selected clip takes over at the best moment of its map. Refused, with a sentence, while WhyNoSnap
  /// has one.
  void SnapToBest();
  /// @return translated; empty: it is possible
  [[nodiscard]] const char* WhyNoSnap() const;

 private:
  /// An edit of the timeline; the clip it returns is selected then.
  void Edit(const std::function<Result<int>(Document&)>& edit);

  Workspace& workspace_;
  SearchRun& search_;
  MotionComparison& comparison_;
  const ResultStore& results_;
  TransitionRun transitions_;
};

}  // namespace gaitsmith::shell
