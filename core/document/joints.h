// SPDX-License-Identifier: MIT
// How strong a document's joints are: as strong as needed (model 1), or limited (model 2).
#pragma once

#include "core/document/document.h"

namespace gaitsmith {

/// Whether the joints give way above their strength.
[[nodiscard]] bool HasLimitedJoints(const Document&);

/// The greatest strength of a joint, in M g L of the figure; 0 for a figure without joints.
[[nodiscard]] float JointStrength(const Document&);

/// How many times as heavy as the lightest rod the heaviest one is, at least 1.
[[nodiscard]] float MassRatio(const Figure&);

/// Above this mass ratio limited joints may spin the lightest rods until the motion is void.
inline constexpr float kMostMassRatio = 100.0f;

/// Whether the joints are limited and the mass ratio is above kMostMassRatio: valid, but worth a warning.
[[nodiscard]] bool HasUnequalRods(const Document&);

/// Lets the joints be as strong as they need to be. A figure of springs has none, and stays as it is.
void FreeJoints(Document&);

/// Limits the joints, if there are any. They keep the strengths that their figure gives them.
void LimitJoints(Document&);

/// Gives all joints one strength [0, 1000], in M g L of the figure, also in the body as it was drawn.
void SetJointStrength(float strength, Document&);

/// Whether the joints of two documents can do the same: both as much as needed, or both limited, with the
/// same strengths and stiffness. What one controller left can be taken over by another only then.
[[nodiscard]] bool SameJoints(const Document&, const Document&);
/// Whether two documents have the same rods, whatever their joints can do, or the same nodes and springs.
[[nodiscard]] bool SameRods(const Document&, const Document&);

}  // namespace gaitsmith
