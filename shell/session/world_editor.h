// SPDX-License-Identifier: MIT
// The world around the figure: ground, gravity and pushes, and how they were when the document was opened.
// What a person does to the world is part of the document, so that a link carries it.
#pragma once

#include <cstddef>

#include "shell/session/workspace.h"

namespace gaitsmith::shell {

class WorldEditor {
 public:
  explicit WorldEditor(Workspace& workspace) : workspace_(workspace) {}

  /// An impulse on an endpoint (or kCentreOfMass) at the moment that is shown [N s], along the ground and
  /// away from it. @return false, with a sentence, when there are too many pushes
  bool Push(int endpoint, float impulse_x_ns, float impulse_y_ns);
  /// @param index of the document's pushes
  void RemovePush(std::size_t index);
  /// Ground, gravity and pushes differ from what was opened.
  [[nodiscard]] bool Changed() const;
  void Reset();
  /// The document as it was opened, for its world.
  [[nodiscard]] const Document& AsOpened() const { return as_opened_; }

  /// After each new motion. @param opened  another document took the place of the present one
  void Follow(bool opened);

 private:
  Workspace& workspace_;
  Document as_opened_;
};

}  // namespace gaitsmith::shell
