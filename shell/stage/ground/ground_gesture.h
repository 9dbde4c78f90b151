// SPDX-License-Identifier: MIT
// Drawing the ground on the stage: a drag draws a line, or moves a corner. A press chooses one.
#pragma once

#include <optional>
#include <vector>

#include "shell/stage/scene.h"

namespace gaitsmith::shell {

struct GroundGesture {
  std::vector<Corner> drawn;        // the line so far
  std::optional<std::size_t> held;  // the corner under the pointer
  bool moved = false;               // it was dragged, not only pressed
};

/// The view while a person draws: the ground rests, whatever the figure does on it. The start is at the left,
/// with room below for gaps. Zoom and pan move it.
[[nodiscard]] Camera AimAtGround(const Playback&, const Environment&, const CameraSettings&,
                                 const ImRect& rect);

/// The stage's drag, while a person draws the ground.
/// @param open  the part of the stage that no card covers
void DrawGroundByHand(Session&, GroundGesture&, const Scene&, const Touch& stage, const ImRect& open,
                      CameraSettings&);

/// Draws the corners, the line so far, and where the pointer is in metres.
/// @param pointed  the stage is pointed at
void DrawCorners(const Scene&, const GroundGesture&, const ImRect& open, bool pointed);

/// The buttons at the upper left of the stage.
void DrawGroundTools(Ui&, Session&, CameraSettings&, const ImRect& stage);

}  // namespace gaitsmith::shell
