// SPDX-License-Identifier: MIT
// Plans to begin with, and how a plan keeps up with edits of its document.
#pragma once

#include <vector>

#include "core/document/document.h"

namespace gaitsmith {

/// The endpoints that stand in the drawn pose at the start [indices in the skeleton's order].
[[nodiscard]] std::vector<int> StandingAtStart(const Document&);

/// A jump to the right by a quarter of the figure's height, from the drawn pose back into it.
[[nodiscard]] Plan JumpPlan(const Document&);

/// When each endpoint stands in a motion: as long as the ground pushes it. Short breaks are closed, and what
/// is too short to stand is left out.
/// @param steps of the plan; the motion may be longer or shorter
[[nodiscard]] std::vector<Stance> StancesOf(const Motion& motion, int steps);

/// Whether two plans ask for the same motion.
[[nodiscard]] bool SameWishes(const Plan&, const Plan&);

/// Forgets a solution that has another number of unknowns than the document's figure and plan.
void DropStaleSolution(Document&);

}  // namespace gaitsmith
