// SPDX-License-Identifier: MIT
// The Style panel: the weights that define a good motion, and what the present one measures.
#pragma once

#include "shell/panels/style/example_form.h"
#include "shell/session/session.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct StylePanelState {
  bool sum = false;  // whether the parts of the score are unfolded
  ExampleFormState example;
};

void DrawStylePanel(Ui&, Session&, StylePanelState&);

}  // namespace gaitsmith::shell
