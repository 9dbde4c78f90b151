// SPDX-License-Identifier: MIT
// The switch of Live, on every panel whose changes it follows.
#pragma once

#include <string_view>

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// Nothing while there is no motion that could follow a change. @param id of the widget, unique
void DrawLiveSwitch(Ui&, Session&, std::string_view id);

}  // namespace gaitsmith::shell
