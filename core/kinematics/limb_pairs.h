// SPDX-License-Identifier: MIT
// Limbs that can take each other's part, such as two legs at one hip: alike, at the same place of the same
// rod. A gait's second half is often its first with these limbs exchanged.
#pragma once

#include <array>

#include "core/kinematics/posture.h"

namespace gaitsmith {

struct LimbPairs {
  /// No limb has a partner.
  LimbPairs();

  std::array<int, kMaxRods> rod;           // the one that takes its part; itself if it has no partner
  std::array<int, kMaxContacts> endpoint;  // the one at the same place of that limb
  bool any = false;
};

/// Only where exactly two limbs of a place are alike: any two arms of a star are. None of a figure of
/// springs.
[[nodiscard]] LimbPairs LimbPairsOf(const Skeleton&);

/// Each limb as its partner was.
[[nodiscard]] Posture Exchanged(const Skeleton&, const LimbPairs&, const Posture&);

}  // namespace gaitsmith
