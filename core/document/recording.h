// SPDX-License-Identifier: MIT
// Records a motion as a trajectory, so that the same motion exists in both forms: as rules that sense, and as
// curves that only know the time.
#pragma once

#include "core/document/document.h"

namespace gaitsmith {

struct Recording {
  Document document;         // the same, but its one controller is a trajectory of the whole motion
  double worst_rad = 0.0;    // see CurveFit
  double typical_rad = 0.0;  // see CurveFit
};

/// @param document must be valid
/// @param knots    evenly spaced over the motion, [2, kMaxRules]
/// @return an error if the document has no controller, or its figure no joint
[[nodiscard]] Result<Recording> RecordAsCurves(const Document& document, int knots);

}  // namespace gaitsmith
