// SPDX-License-Identifier: MIT
// A planned motion tracked by rules: rules that imitate it, and a search that makes them better at it. A
// trajectory plays the plan by heart; rules can answer what the plan did not foresee.
#pragma once

#include "core/document/document.h"

namespace gaitsmith {

/// Each rule has a share of the plan's time in which the joints turn as far as in any other. It acts by the
/// timer, or where the senses are as they are planned when its share begins. Its pose and time constant bring
/// the joints to where they are planned to be at the end of the share.
/// @return the document with these rules as its one controller. Its search starts with them and is scored as
///         if the planned way of the centre of mass had been shown, and the pose of the last keyframe that
///         asks for one, or else the highest pose. An error if there is no planned motion
[[nodiscard]] Result<Document> TrackPlan(const Document& document);

}  // namespace gaitsmith
