// SPDX-License-Identifier: MIT
// A motion as a glTF 2.0 scene: the figure's rods as nodes, its joints turned by an animation. Blender and
// Godot open it as it is.
#pragma once

#include <string>

#include "core/document/document.h"

namespace gaitsmith::shell {

/// Metres, y upwards, the ground the plane y = 0, tilted as a whole where it slopes (how it sways is left
/// out). Node 0 is the scene's, the others the rods in walking order: each lies along its own x, from its
/// start.
/// @param motion of the document
[[nodiscard]] std::string SkeletonGltf(const Document& document, const Motion& motion);

}  // namespace gaitsmith::shell
