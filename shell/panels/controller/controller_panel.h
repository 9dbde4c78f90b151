// SPDX-License-Identifier: MIT
// The Controller panel: the figure's senses, its rules as cards, and the editor of one rule.
#pragma once

#include "shell/panels/controller/rule_editor.h"
#include "shell/panels/controller/rule_why.h"

namespace gaitsmith::shell {

/// The panel's state between frames.
struct ControllerPanelState {
  RuleWhyState why;
  RuleEditorState editor;
};

void DrawControllerPanel(Ui&, Session&, ControllerPanelState&);

}  // namespace gaitsmith::shell
