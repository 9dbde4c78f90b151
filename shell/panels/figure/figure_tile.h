// SPDX-License-Identifier: MIT
// A card with a figure and its name, one of several to choose from.
#pragma once

#include <string>

#include "core/physics/figure.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// @param id stable and unique. @return true if it was pressed
bool DrawFigureTile(Ui&, const Figure&, const std::string& id, bool chosen, const ImRect&);

}  // namespace gaitsmith::shell
