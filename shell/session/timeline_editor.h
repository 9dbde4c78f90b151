// SPDX-License-Identifier: MIT
// Edits of the timeline: the clips chained into one motion, the selected clip, and its controller. An
// impossible edit changes nothing and reports why. A clip keeps its length when it is moved.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/numeric/error.h"
#include "shell/results/result_store.h"
#include "shell/results/search_run.h"
#include "shell/session/motion_comparison.h"
#include "shell/session/transition_run.h"
#include "shell/workspace/workspace.h"

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

  /// The selected clip. Its controller is shown, and a search replaces it.
  [[nodiscard]] int Selected() const { return workspace_.SelectedClip(); }
  /// @param clip any number: the nearest clip is selected
  void Select(int clip) { workspace_.SelectClip(clip); }
  /// Null if there is no motion.
  [[nodiscard]] const Controller* ShownController() const { return workspace_.ShownController(); }
  /// Edits the shown controller by hand. Its name records the edit, a search that would replace it ends, and
  /// search settings that equal its number of rules follow it.
  bool ChangeController(const std::function<void(Controller&)>& edit);

  /// Appends a copy of the selected clip.
  void AddClip();
  void RemoveClip();
  /// Moves the border before a clip; clips behind it stay where they are. @param start_step [0, kMaxSteps)
  void MoveClip(int clip, int start_step);
  /// @param steps at least kShortestClip
  void SetClipLength(int clip, int steps);
  /// Splits the clip that plays at the shown moment.
  void SplitClip();
  void DuplicateClip();
  /// Mirrors the selected clip, so that it moves in the other direction.
  void MirrorClip();
  /// @param to the new index of the selected clip
  void ReorderClip(int to);
  /// Appends a copy of the whole timeline.
  void Repeat();
  /// Replaces the whole timeline by a trajectory, says how well it fits, and shows the motion of before
  /// beside it.
  /// @return false, with a sentence: it is not possible
  bool RecordAsCurves();
  /// Inserts all clips of a found motion at the shown moment.
  /// @param step  where to insert instead
  /// @return false: there is no such motion, or it does not fit
  bool InsertFound(const std::string& id, std::optional<int> step = {});
  /// Improves the selected clip's controller by a short search.
  void RepairClip() { search_.ImproveClip(); }
  [[nodiscard]] bool CanRepair() const { return search_.CanImproveClip(); }
  /// Sets the length of the motion, task and senses together while there is only one clip.
  /// @param steps [1, kMaxSteps]
  void SetDuration(int steps);

  /// Where the selected clip takes over, and where it could take over.
  [[nodiscard]] TransitionRun& Transitions() { return transitions_; }
  [[nodiscard]] const TransitionRun& Transitions() const { return transitions_; }
  /// Moves the start of the selected clip to the nearest good moment of its map. Refused with the sentence of
  /// WhyNoSnap, if that is not empty.
  void SnapToBest();
  /// Whether the transition map is there to snap to, though it may have no good moment.
  [[nodiscard]] bool MapComplete() const;
  /// @return translated; empty if SnapToBest is possible
  [[nodiscard]] const char* WhyNoSnap() const;

 private:
  /// Edits the timeline and selects the clip that the edit returns. @return false, with a sentence: it is
  /// not possible
  bool Edit(const std::function<Result<int>(Document&)>& edit);

  Workspace& workspace_;
  SearchRun& search_;
  MotionComparison& comparison_;
  const ResultStore& results_;
  TransitionRun transitions_;
};

}  // namespace gaitsmith::shell
