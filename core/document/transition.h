// SPDX-License-Identifier: MIT
// How well a controller takes over from another one: how near the figure is to where the controller usually
// is, and what becomes of it from there.
#pragma once

#include "core/document/document.h"
#include "core/rollout/transition_map.h"

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

/// A transition map has a moment every so many steps,
inline constexpr int kMomentSpacing = 5;
/// and watches a controller for as long as the task says, but no longer than this [steps].
inline constexpr int kLongestWatch = 1000;

/// Steps at which a clip could take over while its neighbours keep theirs: multiples of kMomentSpacing,
/// ascending. @return none for the first clip, and where there is no room to move
[[nodiscard]] std::vector<int> TransitionSteps(const Document&, int clip);
/// All that the transition map of a clip depends on, and nothing else: where the clip begins now is not part
/// of it. @param clip has TransitionSteps @return a document whose search.in_place_of is the clip
[[nodiscard]] Document TransitionRequest(const Document&, int clip);
/// Scored as the task says; but a controller that usually travels the other way, as a mirrored one, by how
/// far it gets that way. @param request of TransitionRequest, or any document whose search.in_place_of has
/// TransitionSteps
[[nodiscard]] TransitionMap TransitionMapOf(const Document& request);

/// What a score is worth beside the usual one: 1 as good, 0 worse by as much as the usual one is away from 0.
/// Usual scores below 0 are measured alike. kVoidScore stays what it is.
[[nodiscard]] float ShareOfUsual(float score, float usual);

}  // namespace gaitsmith
