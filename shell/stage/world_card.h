// SPDX-License-Identifier: MIT
// A card on the stage with the settings of ground, gravity, pushes, joints and the compared motion.
#pragma once

#include "shell/session/session.h"
#include "shell/stage/ground/ground_form.h"
#include "shell/widgets/widgets.h"

namespace gaitsmith::shell {

/// The card's state between frames.
struct WorldCardState {
  bool open = false;
  float height = 510.0f;  // height of the contents [points]
  int endpoint = 0;       // target of the next push; 0: the centre of mass, k: endpoint k - 1
  double strength_ns = 5.0;
  double direction_deg = 0.0;  // counterclockwise from the right along the ground
  GroundFormState ground;
  bool rods_only = false;  // the stage shows what is simulated, without a body
};

/// The button in the stage's corner.
void DrawWorldButton(Ui&, WorldCardState&, const ImRect& stage);
/// The card's rectangle on a sufficiently large stage.
[[nodiscard]] ImRect WorldCardOn(const ImRect& stage, const WorldCardState&);
void DrawWorldCard(Ui&, Session&, WorldCardState&, const ImRect& card);

}  // namespace gaitsmith::shell
