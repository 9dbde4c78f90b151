// SPDX-License-Identifier: MIT
// A collapsible section of a panel.
#pragma once

#include <string_view>

#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// Draws the heading. Click it to open or close the section. The caller draws the open section.
/// @param note  text at the right, e.g. the number of entries
/// @return whether the section is open
bool DrawFold(Ui&, std::string_view id, std::string_view title, std::string_view note, bool& open);

}  // namespace gaitsmith::shell
