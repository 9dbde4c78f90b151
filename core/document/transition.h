// SPDX-License-Identifier: MIT
// How well a controller takes over from another one: how near the figure is to where the controller usually
// is, and what becomes of it from there.
#pragma once

#include "core/control/controllers.h"
#include "core/document/document.h"
#include "core/physics/motion_state.h"

namespace gaitsmith {

/// How far a state of a figure lies from a motion of the same figure.
struct Nearness {
  float distance =
      0.0f;  // 0: it is a state of that motion; about 1: every part is off by as much as it usually moves
  int frame = 0;  // of the motion, the nearest one
};
/// Compares joint angles and rates, turn, height and velocity of the centre of mass; where along the ground
/// does not matter.
/// @param frame of `motion` @param usual of the same figure, at least one frame
[[nodiscard]] Nearness NearnessOf(const Motion& motion, int frame, const Motion& usual);

/// The motion of a clip's controller alone from the document's start, without pushes, as long as the task
/// says.
[[nodiscard]] Motion UsualMotion(const Document&, int controller);

/// For one clip of a timeline: what its controller would do if it took over at other moments, while the clip
/// before it goes on until then.
class TransitionMap {
 public:
  /// @param document valid; copied
  /// @param clip   in [1, clips)
  /// @param every  steps between two moments, at least 1
  /// @param after  how long the controller is watched [steps], at least 1
  TransitionMap(const Document& document, int clip, int every, int after);

  /// Moments at which it could take over: from shortly after the clip before it has begun to as long again as
  /// that lasts now, and no later than a motion may last.
  [[nodiscard]] int Count() const { return static_cast<int>(moments_.size()); }
  [[nodiscard]] int StepOf(int index) const { return moments_[static_cast<std::size_t>(index)].step; }
  /// Simulates. @param index below Count()
  /// @return what the task gives for what follows from there; kVoidScore where physics breaks
  [[nodiscard]] float ScoreAt(int index) const {
    return ScoreFrom(&moments_[static_cast<std::size_t>(index)]);
  }
  /// What the controller reaches in that time from the document's start, without pushes: what scores are
  /// measured by.
  [[nodiscard]] float UsualScore() const { return ScoreFrom(nullptr); }

 private:
  [[nodiscard]] float ScoreFrom(const Moment<1>* moment) const;

  Document document_;
  Skeleton skeleton_;
  Controllers<1> controller_;  // of the clip
  int after_;
  std::vector<Moment<1>> moments_;
};

}  // namespace gaitsmith
