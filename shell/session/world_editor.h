// SPDX-License-Identifier: MIT
// The world around the figure: ground, gravity and pushes, as edited and as opened. Edits of the world are
// part of the document, so links carry them.
#pragma once

#include <cstddef>

#include "shell/workspace/workspace.h"

namespace gaitsmith::shell {

class WorldEditor {
 public:
  explicit WorldEditor(Workspace& workspace) : workspace_(workspace) {}

  /// Adds an impulse on an endpoint (or kCentreOfMass) at the shown moment: its components along the ground
  /// and away from it [N s]. @return false, with a sentence, if there are too many pushes
  bool Push(int endpoint, float impulse_x_ns, float impulse_y_ns);
  /// Pushes the figure's centre of mass against the direction in which it moves, as hard as a person would
  /// shove it.
  void Shove();
  /// @param index of the document's pushes
  void RemovePush(std::size_t index);
  /// Lets the joints give way above their strength, or be as strong as they need to be.
  void LimitJoints(bool limited);
  /// @param strength of all joints, in M g L of the figure
  void SetJointStrength(float strength);
  /// Whether ground, gravity, pushes or joints differ from those that were opened.
  [[nodiscard]] bool Changed() const;
  void Reset();
  /// The document as it was opened, whose world Reset restores.
  [[nodiscard]] const Document& AsOpened() const { return as_opened_; }

  /// Call after each new motion. @param opened  another document replaced the present one
  void Follow(bool opened);

 private:
  Workspace& workspace_;
  Document as_opened_;
};

}  // namespace gaitsmith::shell
