// SPDX-License-Identifier: MIT
// How much a motion is like itself some time later: its autocorrelation, over where endpoints are, how fast
// they are, and which of them the ground bears.
#pragma once

#include <vector>

#include "core/kinematics/limb_pairs.h"

namespace gaitsmith {

class Likeness {
 public:
  /// @param first, last frames of the motion to look at, 0 <= first < last < motion.Frames()
  /// @param pairs  whose limbs take each other's part later on
  Likeness(const Motion& motion, int first, int last, const LimbPairs& pairs);

  /// 1: the same; 0: as different as two of its instants usually are. Where it is along the ground does not
  /// count, nor do whole turns. @param lag in frames, [1, last - first]
  [[nodiscard]] double After(int lag) const;

  /// How far its parts usually are from their mean: root mean square [longest rod].
  [[nodiscard]] double Liveliness() const { return liveliness_; }

 private:
  std::size_t frames_, width_;
  std::vector<double> state_, later_;  // (frames x width): as it is, and with limbs exchanged
  double liveliness_ = 0.0;
};

}  // namespace gaitsmith
