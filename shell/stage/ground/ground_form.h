// SPDX-License-Identifier: MIT
// The rows of the World card about the ground: presets, drawing by hand, and its corners as numbers.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct GroundFormState {
  bool corners_open = false;
};

void DrawGroundForm(Ui&, Session&, GroundFormState&);

}  // namespace gaitsmith::shell
