// SPDX-License-Identifier: MIT
// Teaching by example: the way and the pose that the figure is shown, as tools for the stage and as numbers.
#pragma once

#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct ExampleFormState {
  bool open = false;
  int point = 1, joint = 1;  // whose numbers are shown, from 1
};

void DrawExampleForm(Ui&, Session&, ExampleFormState&);

}  // namespace gaitsmith::shell
