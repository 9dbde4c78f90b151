// SPDX-License-Identifier: MIT
// The border between the stage and the panel, which a person drags to give either more room.
#pragma once

#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

struct Split {
  float size = 0.0f;  // of the panel [points]; 0: nobody chose one

  /// The panel's width or height. @param usual  if nobody chose
  [[nodiscard]] float Size(float usual, float least, float most) const;
};

/// Where the border is [points].
struct SplitPlace {
  float border;
  float edge;         // the panel's far end
  float first, last;  // the border's ends
  bool upright;       // the panel is beside the stage, not below it
};

/// Draws the handle over the border. @param least, most  of the panel's size
void DrawSplit(Ui&, Split&, const SplitPlace&, float least, float most);

}  // namespace gaitsmith::shell
