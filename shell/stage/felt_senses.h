// SPDX-License-Identifier: MIT
// Shows on the body what a rule feels: at the place of each sense that it uses, the interval in which the
// rule is right, and the present value.
#pragma once

#include <span>

#include "core/control/controller.h"
#include "shell/stage/scene.h"

namespace gaitsmith::shell {

/// Draws nothing while another clip is active, or if the controller has no such rule.
/// @param controller of the selected clip
/// @param endpoints  canvas positions, as DrawScene returns them
void DrawFeltSenses(const Scene&, const Controller& controller, int rule, std::span<const ImVec2> endpoints);

}  // namespace gaitsmith::shell
