// SPDX-License-Identifier: MIT
// The shape that a figure is drawn with: thickness of the limbs, head, which limbs are on the far side. The
// simulation knows only rods.
#pragma once

#include <array>
#include <string_view>

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
  struct Limb {
    float start_m = 0.0f, end_m = 0.0f;  // radius at its ends
    Side side = Side::kMiddle;
  };

  std::array<Limb, kMaxRods> limbs{};  // in the skeleton's order
  float middle_m = 0.0f;               // radius of a limb of middling weight
  float belly_m = 0.0f;                // by how much the root swells halfway
  float hub_m = 0.0f;                  // radius of a disc at the root's start; 0: none
  Head head = Head::kNone;
  int head_rod = -1;
  float head_m = 0.0f;  // radius of a round head
  float crown = 1.0f;   // 1: the head's top is to the left of its rod; -1: to the right, in a mirrored figure
  float sole_m = 0.0f;  // how far outlines reach below the endpoints that the drawn pose stands on
};

/// The look of a figure. A thicker limb is a heavier rod: the radius follows the root of mass per length,
/// from 0.62 to 2 times the middle. Of two like limbs at one joint the first is on the far side.
/// @param name shipped figures are known by it, up to a comma. Others have no head
[[nodiscard]] FigureLook LookOf(std::string_view name, const Skeleton&);

}  // namespace gaitsmith::shell
