// SPDX-License-Identifier: MIT
// Records a motion as a trajectory, so that the same motion exists in both forms: as rules that sense, and as
// curves that only know the time.
#pragma once

#include <span>
#include <string>

#include "core/document/document.h"
#include "core/rollout/curve_fit.h"

namespace gaitsmith {

struct Recording {
  Document document;         // the same, but its one controller is a trajectory of the whole motion
  double worst_rad = 0.0;    // see CurveFit
  double typical_rad = 0.0;  // see CurveFit
};

/// A document whose one controller is a trajectory that moves the joints like given ones.
/// @param angles_rad of joints, from the drawn pose on (frames x joints), of at least one joint
/// @param fit        set to how well it does
[[nodiscard]] Document WithTrajectory(const Document&, std::string name, std::span<const float> angles_rad,
                                      int knots, CurveFit& fit);

/// @param document must be valid
/// @param knots    evenly spaced over the motion, [2, kMaxRules]
/// @return an error if the document has no controller, or its figure no joint
[[nodiscard]] Result<Recording> RecordAsCurves(const Document& document, int knots);

}  // namespace gaitsmith
