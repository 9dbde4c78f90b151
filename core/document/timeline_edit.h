// SPDX-License-Identifier: MIT
// Editing a timeline: clips that are cut, moved and repeated. Lengths travel with their clips, so what comes
// later moves along, unless said otherwise. Every edit either succeeds or changes nothing and says why.
#pragma once

#include <span>

#include "core/document/document.h"

namespace gaitsmith {

/// A clip lasts at least so long: short enough for a hop, long enough to take hold of.
inline constexpr int kShortestClip = 20;  // steps

/// A clip without its place.
struct Stretch {
  int controller;
  int steps;  // at least 1
};
/// One for each clip; a clip that lies behind the end of the motion counts as the shortest.
[[nodiscard]] std::vector<Stretch> StretchesOf(const Document&);

/// The clip in charge at a step of the motion. @param document has a clip
[[nodiscard]] int ClipAt(const Document& document, int step);

/// Moves the border before a clip, in [1, clips): the clips beside it share what they have; what comes later
/// stays. The step is clamped to what leaves both kShortestClip.
[[nodiscard]] Result<void> MoveSwitch(Document&, int clip, int step);
/// Sets how long a clip lasts, clamped to kShortestClip and above.
[[nodiscard]] Result<void> SetClipLength(Document&, int clip, int steps);
/// Cuts the clip in charge at a step in two. Its controller begins anew after the cut: its first rule, its
/// timer at zero.
[[nodiscard]] Result<void> SplitClip(Document&, int step);
[[nodiscard]] Result<void> RemoveClip(Document&, int clip);
/// A copy behind the clip itself.
[[nodiscard]] Result<void> DuplicateClip(Document&, int clip);
/// Takes a clip to the place `to`, counted among all clips.
[[nodiscard]] Result<void> ReorderClip(Document&, int clip, int to);
/// Clips that take over at a step, one after another; the one in charge there goes on behind them. At the end
/// of the motion they are added to it.
[[nodiscard]] Result<void> InsertClips(Document&, const std::vector<Stretch>& inserted, int step);
/// The whole timeline so many times, [2, 100].
[[nodiscard]] Result<void> LoopTimeline(Document&, int times);
/// Gives a clip the mirror image of its controller, so that it goes the other way. Refused for a figure whose
/// mirror image is another figure, and for a network.
[[nodiscard]] Result<void> MirrorClip(Document&, int clip);

/// Adds a controller and returns its index; one that is there already is not added again.
[[nodiscard]] Result<int> AddController(Document&, const Controller&);
/// Takes out controllers that neither a clip nor the search's settings name.
void DropUnusedControllers(Document&);
/// The same, but only of those that these clips used, before a change.
void DropUnusedControllers(Document&, std::span<const Clip> before);

}  // namespace gaitsmith
