// SPDX-License-Identifier: MIT
// The loop in a document's motion: found in what is shown, or by letting its controller run on.
#pragma once

#include "core/document/document.h"
#include "core/gait/closed_loop.h"

namespace gaitsmith {

struct DocumentLoop {
  ClosedLoop loop;
  bool ran_on = false;  // found only after the document's end, where the motion has settled
};

/// In the motion that is shown, of the clip that lasts longest, after a quarter of it and its last push.
/// @param document must be valid @param motion of the document
/// @param halves   look for half a cycle, and make the other half of it: see FindCycle
/// @return an error that says, with numbers, why there is none
[[nodiscard]] Result<DocumentLoop> ShownLoopOf(const Document& document, const Motion& motion, bool halves);

/// The same; but if none is shown, or if its seam does not close, the controller runs on for 40 s, and the
/// last 30 s of that are looked at.
[[nodiscard]] Result<DocumentLoop> LoopOf(const Document& document, const Motion& motion, bool halves);

/// A loop as a motion of one cycle, which begins at x = 0 and whose last frame is the first, moved on.
/// @param in_place without its way along the ground
[[nodiscard]] Motion RecordLoop(const Document& document, const ClosedLoop& loop, bool in_place);

}  // namespace gaitsmith
