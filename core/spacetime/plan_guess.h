// SPDX-License-Identifier: MIT
// A first idea of a planned motion, from which the solver starts: poses eased from keyframe to keyframe, feet
// where they stand, parabolas in flight.
#pragma once

#include "core/spacetime/plan_layout.h"

namespace gaitsmith {

/// @return a value for each unknown of the layout
[[nodiscard]] Eigen::VectorXd GuessPlan(const PlanScene&, const PlanLayout&);

/// The same motion in another layout of the same plan, whose pieces are finer or coarser.
[[nodiscard]] Eigen::VectorXd Resample(const Eigen::VectorXd& unknowns, const PlanLayout& from,
                                       const PlanLayout& to);

}  // namespace gaitsmith
