// SPDX-License-Identifier: MIT
// Finds the trajectory whose joints move most like those of a motion, by least squares over its frames.
#pragma once

#include "core/control/joint_curves.h"
#include "core/rollout/motion.h"

namespace gaitsmith {

struct CurveFit {
  Genome genes;              // of a trajectory
  double worst_rad = 0.0;    // greatest difference of a joint's angle from that of the motion
  double typical_rad = 0.0;  // root of the mean square, over all joints and frames
};

/// The differences are those of joints that nothing but their targets moves, as in model 1.
/// @param motion that a document with this figure starts
/// @param shape  for the motion's figure
/// @param senses of the trajectory: its period, its end and tau_min
[[nodiscard]] CurveFit FitCurves(const Motion& motion, const CurveShape& shape, const SenseSpec& senses);

}  // namespace gaitsmith
