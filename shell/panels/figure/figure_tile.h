// SPDX-License-Identifier: MIT
// A card with a figure and its name, one of several to choose from.
#pragma once

#include <string>
#include <string_view>

#include "core/physics/figure.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// Draws a card's name at its lower edge, in two lines if it is long. @return where the space above it ends
float DrawTileName(Ui&, std::string_view name, const ImRect& tile, ImU32 ink);

/// @param id stable and unique. @return true if it was pressed
bool DrawFigureTile(Ui&, const Figure&, const std::string& id, bool chosen, const ImRect&);

}  // namespace gaitsmith::shell
