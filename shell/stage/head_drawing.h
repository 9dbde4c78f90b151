// SPDX-License-Identifier: MIT
// Draws the heads of figures that have one.
#pragma once

#include <imgui.h>

#include "shell/stage/figure_look.h"

namespace gaitsmith::shell {

/// Where the rod of a head is on the canvas.
struct HeadPlace {
  ImVec2 neck, tip;   // its start and end
  float scale;        // points per metre
  float grow = 0.0f;  // added to every radius [points]
};

/// The head with its rod, without the eye. @param look with a head
void DrawHead(ImDrawList*, const FigureLook& look, const HeadPlace&, ImU32 colour);
void DrawEye(ImDrawList*, const FigureLook& look, const HeadPlace&, ImU32 colour);

}  // namespace gaitsmith::shell
