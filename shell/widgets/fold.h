// SPDX-License-Identifier: MIT
// A section of a panel that folds away under its heading.
#pragma once

#include <string_view>

#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// The heading: a press opens or closes the section; the caller draws it while it is open.
/// @param note  what stands at the right, e.g. how much is in it
/// @return whether it is open
bool DrawFold(Ui&, std::string_view id, std::string_view title, std::string_view note, bool& open);

}  // namespace gaitsmith::shell
