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
  Document document;         // the same, but its controllers are trajectories of the whole motion
  double worst_rad = 0.0;    // see CurveFit
  double typical_rad = 0.0;  // see CurveFit
};

/// A document whose controllers are trajectories that move the joints like given ones, one after another.
/// @param angles_rad of joints, from the drawn pose on (frames x joints), of at least one joint
/// @param knots      of each trajectory
/// @param clips      number of trajectories, for equal parts of the motion, [1, frames / 2)
[[nodiscard]] Recording WithTrajectories(const Document&, const std::string& name,
                                         std::span<const float> angles_rad, int knots, int clips);

/// @param document must be valid
/// @param knots    evenly spaced over the motion, [2, kMaxRules]
/// @return an error if the document has no controller, or its figure no joint
[[nodiscard]] Result<Recording> RecordAsCurves(const Document& document, int knots);

}  // namespace gaitsmith
