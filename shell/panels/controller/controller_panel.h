// SPDX-License-Identifier: MIT
// The Controller panel: what the figure senses, its rules as cards, and the one of them that is being
// changed.
#pragma once

#include "shell/panels/controller/rule_editor.h"
#include "shell/panels/controller/rule_why.h"

namespace gaitsmith::shell {

/// What the panel remembers between frames.
struct ControllerPanelState {
  RuleWhyState why;
  RuleEditorState editor;
};

void DrawControllerPanel(Ui&, Session&, ControllerPanelState&);

}  // namespace gaitsmith::shell
