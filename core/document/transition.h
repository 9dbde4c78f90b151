// SPDX-License-Identifier: MIT
// How well a controller takes over from another one: how it moves from there, compared with its usual motion.
#pragma once

#include "core/document/document.h"
#include "core/rollout/transition_map.h"

namespace gaitsmith {

/// The motion of one controller alone from the document's start, without pushes, for the duration of the
/// task.
[[nodiscard]] Motion UsualMotion(const Document&, int controller);

/// Spacing of a transition map's moments [steps].
inline constexpr int kMomentSpacing = 5;
/// Each moment of a transition map is scored for the duration of the task, but for at most this [steps].
inline constexpr int kLongestWatch = 1000;

/// Steps at which a clip could take over while its neighbours stay: multiples of kMomentSpacing, ascending.
/// @return none for the first clip, or if there is no room to move
[[nodiscard]] std::vector<int> TransitionSteps(const Document&, int clip);
/// Everything that the transition map of a clip depends on, and nothing else. The clip's present start is not
/// part of it.
/// @param clip has TransitionSteps
/// @return a document whose search.in_place_of is the clip
[[nodiscard]] Document TransitionRequest(const Document&, int clip);
/// Scores by the task. A controller that usually travels in the opposite direction of the task, such as a
/// mirrored one, is scored in its own direction. @param request from TransitionRequest, or any document whose
/// search.in_place_of has TransitionSteps
[[nodiscard]] TransitionMap TransitionMapOf(const Document& request);

/// A score relative to the usual one: 1 if equal, 0 if lower by the absolute value of the usual one. Negative
/// usual scores use the same scale. kVoidScore is returned unchanged.
[[nodiscard]] float ShareOfUsual(float score, float usual);

}  // namespace gaitsmith
