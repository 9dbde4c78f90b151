// SPDX-License-Identifier: MIT
// The laws of physics_laws.h that figures of springs keep. Their energy, which muscles, springs and damping
// change, is judged in tests/core/springs.
#pragma once

#include "tests/physics_laws.h"

namespace gaitsmith::test {

/// @param motion the document's, of a figure of springs
[[nodiscard]] Offences JudgeSprings(const Document& document, const Motion& motion);

}  // namespace gaitsmith::test
