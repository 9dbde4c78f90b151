// SPDX-License-Identifier: MIT
// The shape that a figure is drawn with: thickness of the limbs, head, which limbs are on the far side. The
// simulation knows only rods, or springs.
#pragma once

#include <vector>

#include "core/physics/skeleton.h"

namespace gaitsmith::shell {

enum class Head {
  kNone,
  kEye,     // only an eye near the end of the rod
  kBall,    // round
  kBeak,    // of a bird
  kFrog,    // wide, with the eye on top
  kMuzzle,  // of a horse: reaches beyond the rod
  kSnout,   // pointed
};

struct FigureLook {
  enum class Side { kFar, kMiddle, kNear };  // drawn in this order
  /// A rod or a spring.
  struct Limb {
    int from = 0, to = 0;                // endpoints, or nodes
    float start_m = 0.0f, end_m = 0.0f;  // radius at its ends
    Side side = Side::kMiddle;
    float drawn_m = 0.0f;  // length of a muscle as drawn, which is thicker where it is shorter; 0: no muscle
  };

  std::vector<Limb> limbs;   // in the skeleton's order, springs in the figure's
  std::vector<float> knobs;  // radius of a disc at each node of a figure of springs
  float middle_m = 0.0f;     // radius of a limb of middling weight
  float belly_m = 0.0f;      // by how much the root swells halfway
  float hub_m = 0.0f;        // radius of a disc at the root's start; 0: none
  Head head = Head::kNone;
  int head_rod = -1;
  float head_m = 0.0f;  // radius of a round head
  float crown = 1.0f;   // 1: the head's top is to the left of its rod; -1: to the right, in a mirrored figure
  float sole_m = 0.0f;  // how far outlines reach below the endpoints that the drawn pose stands on
};

/// The look of a figure. A thicker limb is a heavier rod: the radius follows the root of mass per length,
/// from 0.62 to 2 times the middle. Of two like limbs at one joint the first is on the far side. Shipped
/// figures are known by their name, up to a comma. Others have no head. A larger node is heavier, a thicker
/// spring a muscle.
[[nodiscard]] FigureLook LookOf(const Figure&);

}  // namespace gaitsmith::shell
