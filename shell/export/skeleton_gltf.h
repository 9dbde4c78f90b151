// SPDX-License-Identifier: MIT
// A motion as a glTF 2.0 scene: rods as nodes, turned by an animation. Blender and Godot open it.
#pragma once

#include <string>

#include "core/document/document.h"

namespace gaitsmith::shell {

/// Metres, y upwards. The ground is the plane y = 0, tilted with the slope but without its sway. Node 0 is
/// the scene. The others are the rods in walking order, each along its own x from its start.
/// @param motion of the document
[[nodiscard]] std::string SkeletonGltf(const Document& document, const Motion& motion);

}  // namespace gaitsmith::shell
