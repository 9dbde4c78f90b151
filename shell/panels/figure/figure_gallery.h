// SPDX-License-Identifier: MIT
// The shipped figures as small drawings in a grid.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// @param open  whether all figures are shown, or only the row with the present figure
/// @param chosen index of the present figure; -1: drawn by hand
/// @return the clicked figure
[[nodiscard]] std::optional<int> DrawFigureGallery(Ui&, const std::vector<Figure>&, int chosen, bool& open);

}  // namespace gaitsmith::shell
