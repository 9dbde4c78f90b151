// SPDX-License-Identifier: MIT
// The keyframes panel: where the figure is at some moments, which endpoints stand when, and what becomes of
// it.
#pragma once

#include "shell/panels/keyframes/keyframe_form.h"
#include "shell/panels/keyframes/stance_bars.h"

namespace gaitsmith::shell {

struct KeyframesPanelState {
  StanceBarsState bars{};
  KeyframeFormState form{};
  int endpoint = 0;  // of the next stance
};

void DrawKeyframesPanel(Ui&, Session&, KeyframesPanelState&);

}  // namespace gaitsmith::shell
