// SPDX-License-Identifier: MIT
// The laws of physics_laws.h that figures of springs keep. Their energy, which muscles, springs and damping
// change, is judged in tests/core/springs.
#pragma once

#include "tests/physics_laws.h"

namespace gaitsmith::test {

/// Nodes end a step at the ground or above it. Single precision places a node of a figure that is 100 m high
/// to 8 micrometres.
inline constexpr std::array<LawLimit, kLaws> kSpringLawLimits = {{
    {"finite", "numbers", 0.0},
    {"joint limits", "rad", 0.0},
    {"above ground", "m", 2e-5},
    {"push", "m/s", 0.0},
    {"cone", "share", 1e-5},
    {"momentum", "share", 1e-4},
    {"flight", "share", 0.0},
    {"moment", "reach + way", 0.0},
    {"still energy", "M g l + E", 0.0},
    {"still gain", "(M g l + E)/s", 0.0},
    {"ground work", "M g l + E", 0.0},
    {"ground gain", "(M g l + E)/s", 0.0},
    {"lifting", "m/s", 0.0},
    {"limb work", "M g l + E", 0.0},
    {"limb gain", "(M g l + E)/s", 0.0},
    {"turning", "share", 0.0},
}};

/// @param motion the document's, of a figure of springs
[[nodiscard]] Offences JudgeSprings(const Document& document, const Motion& motion);

}  // namespace gaitsmith::test
