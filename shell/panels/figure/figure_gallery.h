// SPDX-License-Identifier: MIT
// The shipped figures as small drawings in a grid.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// @param open  all of them, or only the first row and a button that opens the rest
/// @param chosen index of the present figure; -1: a drawing of one's own
/// @return the figure that was pressed
[[nodiscard]] std::optional<int> DrawFigureGallery(Ui&, const std::vector<Figure>&, int chosen, bool& open);

}  // namespace gaitsmith::shell
