// SPDX-License-Identifier: MIT
// Finds the trajectory whose joints move most like given ones, by least squares over the frames.
#pragma once

#include "core/control/joint_curves.h"
#include "core/physics/joint_response.h"

namespace gaitsmith {

struct CurveFit {
  Genome genes;                     // of a trajectory
  double worst_rad = 0.0;           // greatest difference of a joint's angle
  double typical_rad = 0.0;         // root of the mean square, over all joints and frames
  std::vector<FreeJoint> end = {};  // in the last frame (joints)
};

/// The differences are those of joints that nothing but their targets moves, as in model 1.
/// @param angles_rad of joints, relative to the drawn ones (frames x joints)
/// @param shape      for this figure
/// @param senses     of the trajectory: its period, its end and tau_min
/// @param from       in the first frame (joints); empty: in the drawn pose, at rest
[[nodiscard]] CurveFit FitCurves(std::span<const float> angles_rad, const Skeleton& figure,
                                 const CurveShape& shape, const SenseSpec& senses,
                                 std::span<const FreeJoint> from = {});

}  // namespace gaitsmith
