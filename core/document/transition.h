// SPDX-License-Identifier: MIT
// How well a controller takes over from another one: how near the figure is to where the controller usually
// is.
#pragma once

#include "core/document/document.h"

namespace gaitsmith {

/// How far a state of a figure lies from a motion of the same figure.
struct Nearness {
  float distance =
      0.0f;  // 0: it is a state of that motion; about 1: every part is off by as much as it usually moves
  int frame = 0;  // of the motion, the nearest one
};
/// Compares joint angles and rates, turn, height and velocity of the centre of mass; where along the ground
/// does not matter.
/// @param frame of `motion` @param usual of the same figure, at least one frame
[[nodiscard]] Nearness NearnessOf(const Motion& motion, int frame, const Motion& usual);

/// The motion of a clip's controller alone from the document's start, without pushes, as long as the task
/// says.
[[nodiscard]] Motion UsualMotion(const Document&, int controller);

}  // namespace gaitsmith
