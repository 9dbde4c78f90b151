// SPDX-License-Identifier: MIT
// Teaching by example: a person shows a way for the figure's centre of mass, or a pose at a moment, and the
// next search meets it. Both are part of the document's task.
#pragma once

#include <vector>

#include "shell/session/ground_editor.h"
#include "shell/workspace/workspace.h"

namespace gaitsmith::shell {

class Teacher {
 public:
  /// What a drag on the stage shows the figure.
  enum class Tool { kNone, kWay, kPose };
  /// Points of a way that was drawn by hand.
  static constexpr std::size_t kDrawnPoints = 12;

  Teacher(Workspace& workspace, GroundEditor& ground) : workspace_(workspace), ground_(ground) {}

  [[nodiscard]] const Demonstration& Shown() const { return workspace_.Doc().task.shown; }
  [[nodiscard]] Tool InHand() const { return in_hand_; }
  /// Takes a tool and stops the motion at the moment that it is about: a way at its start, a pose where it
  /// is. Taking the pose without one shows the present one first. Drawing the ground ends.
  void Take(Tool);
  void PutAway() { in_hand_ = Tool::kNone; }

  /// Shows a way as it was drawn, at an even pace from the start of the task to its end. @param drawn at
  /// least two points at different places; their steps are not read
  void ShowWay(const std::vector<WayPoint>& drawn);
  /// Adds the place of the centre of mass at the shown moment, or moves the point that is there.
  void AddPlaceNow();
  /// @param index of Shown().way. @param point between its neighbours in time
  void MovePoint(std::size_t index, WayPoint point);
  void RemovePoint(std::size_t index);
  void ForgetWay();

  /// The figure's pose at the shown moment becomes the one that is shown.
  void ShowPoseNow();
  /// @param joint of the figure @param angle_rad within its limits
  void TurnJoint(std::size_t joint, float angle_rad);
  /// @param turn_rad direction of the root rod; whole turns are taken away
  void TurnWhole(float turn_rad);
  void ForgetPose();

  /// Call after each new motion. @param opened another document replaced the present one
  void Follow(bool opened);

 private:
  /// Changes what is shown. What is new gets the usual weight, what is gone has none.
  void Show(Demonstration);

  Workspace& workspace_;
  GroundEditor& ground_;
  Tool in_hand_ = Tool::kNone;
};

}  // namespace gaitsmith::shell
