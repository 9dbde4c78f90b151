// SPDX-License-Identifier: MIT
// A planned motion frame by frame, as if it had been simulated: for drawing, measuring and exporting it.
#pragma once

#include "core/document/document.h"
#include "core/spacetime/planned_motion.h"

namespace gaitsmith {

/// The motion of a document's plan. A plan without a solution is an error.
[[nodiscard]] Result<Motion> RecordPlanned(const Document& document);

/// @param document of the plan. The motion lasts as long as the document's, held after the plan's end
[[nodiscard]] Motion RecordPlanned(const Document& document, const PlannedMotion& planned);

}  // namespace gaitsmith
