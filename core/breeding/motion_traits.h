// SPDX-License-Identifier: MIT
// How the motion of a document looks, for comparisons of motions that did not come from one brood.
#pragma once

#include "core/document/document.h"
#include "core/signal/traits.h"

namespace gaitsmith {

/// The traits of the first clip's controller alone, over the task's duration.
/// @return an error if the document has no motion, or its motion breaks physics
[[nodiscard]] Result<Traits> MotionTraits(const Document&);

}  // namespace gaitsmith
