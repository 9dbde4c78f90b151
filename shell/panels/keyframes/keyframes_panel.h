// SPDX-License-Identifier: MIT
// The keyframes panel: where the figure is at some moments, which endpoints stand when, and what becomes of
// it.
#pragma once

#include "shell/panels/keyframes/angle_curves.h"
#include "shell/panels/keyframes/keyframe_form.h"
#include "shell/panels/keyframes/stance_bars.h"

namespace gaitsmith::shell {

struct KeyframesPanelState {
  int view = 0;   // 0: times of standing, 1: angles
  int joint = 0;  // of the view of angles
  StanceBarsState bars{};
  KeyframeFormState form{};
  int endpoint = 0;  // of the next stance
};

void DrawKeyframesPanel(Ui&, Session&, KeyframesPanelState&);

}  // namespace gaitsmith::shell
