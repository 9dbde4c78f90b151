// SPDX-License-Identifier: MIT
// The Controller panel: the figure's senses, its rules as cards, and the editors of a rule and of curves.
#pragma once

#include "shell/panels/controller/curve_editor.h"
#include "shell/panels/controller/rule_editor.h"
#include "shell/panels/controller/rule_why.h"

namespace gaitsmith::shell {

/// The panel's state between frames.
struct ControllerPanelState {
  RuleWhyState why;
  RuleEditorState editor;
  CurveEditorState curves;

  /// The rule that a person looks at: under the pointer, with the focus, or open in the editor; -1: none.
  [[nodiscard]] int LookedAt() const { return why.pointed_at >= 0 ? why.pointed_at : editor.rule; }
};

void DrawControllerPanel(Ui&, Session&, ControllerPanelState&);

}  // namespace gaitsmith::shell
