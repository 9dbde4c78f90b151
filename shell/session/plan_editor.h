// SPDX-License-Identifier: MIT
// Edits of the document's plan: keyframes, marks and stances.
#pragma once

#include <algorithm>
#include <functional>

#include "core/planning/plan_draft.h"
#include "shell/workspace/workspace.h"

namespace gaitsmith::shell {

class PlanEditor {
 public:
  explicit PlanEditor(Workspace& workspace) : workspace_(workspace) {}

  [[nodiscard]] const Plan& Shown() const { return workspace_.Doc().plan; }
  /// Whether the document has a plan.
  [[nodiscard]] bool Open() const { return !Shown().Empty(); }

  /// The chosen keyframe, an index; -1: there is none.
  [[nodiscard]] int Chosen() const {
    return std::min(chosen_, static_cast<int>(Shown().keyframes.size()) - 1);
  }
  /// @param keyframe at least 0
  void Choose(int keyframe) { chosen_ = keyframe; }

  /// Why the figure can have no plan. Empty: it can.
  [[nodiscard]] const char* WhyNot() const;
  /// Makes the first plan of a document, a jump, if there is none.
  /// @return false, with a sentence: WhyNot, or the plan is locked
  bool Begin();
  /// Changes the plan, whose solution is forgotten. Keyframes stay sorted.
  bool Change(const std::function<void(Plan&)>& edit);
  /// Adds a keyframe at the shown moment, with the pose and the turn of the planned motion, or of the shown
  /// one if none is planned, and chooses it.
  /// @return false, with a sentence: there are too many, or there is one at this moment, which is chosen
  bool AddKeyframe();
  void RemoveKeyframe(int keyframe);
  /// Moves it in time, and chooses it.
  void MoveKeyframe(int keyframe, int step);
  /// Moves what counts of a mark's place. @param x_m, y_m see Mark
  void MoveMark(int keyframe, int mark, float x_m, float y_m);
  /// Adds a stance of an endpoint at the shown moment, where it does not stand yet.
  void AddStance(int endpoint);
  void RemoveStance(int stance);
  /// Moves one end of a stance as far as its neighbours and the plan allow.
  void MoveStance(int stance, bool last, int step);
  /// All stances from the shown motion.
  void TakeStances();
  /// @param steps [20, kMaxPlanSteps]; keyframes and stances at the end move with it
  void SetLength(int steps);
  /// Removes the whole plan. The motion stays.
  void Clear();

 private:
  /// Chooses the keyframe that is this one.
  void Choose(const Keyframe&);

  Workspace& workspace_;
  int chosen_ = 0;
};

}  // namespace gaitsmith::shell
