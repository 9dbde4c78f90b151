// SPDX-License-Identifier: MIT
// Edits of a timeline: cut, move and repeat clips. Clips keep their lengths, so later clips move along,
// except where noted. Every edit either succeeds or changes nothing and returns the reason.
#pragma once

#include <span>

#include "core/document/document.h"

namespace gaitsmith {

/// Shortest clip: short enough for a hop, long enough to grab.
inline constexpr int kShortestClip = 20;  // steps

/// A clip without its start.
struct Stretch {
  int controller;
  int steps;  // at least 1
};
/// One stretch for each clip. A clip after the end of the motion gets the shortest length.
[[nodiscard]] std::vector<Stretch> StretchesOf(const Document&);

/// The active clip at a step of the motion. @param document has at least one clip
[[nodiscard]] int ClipAt(const Document& document, int step);

/// Moves the border before a clip in [1, clips). The two neighbours share their total length, and later clips
/// stay. The step is clamped so that both last at least kShortestClip.
[[nodiscard]] Result<void> MoveSwitch(Document&, int clip, int step);
/// Sets the length of a clip, clamped to at least kShortestClip.
[[nodiscard]] Result<void> SetClipLength(Document&, int clip, int steps);
/// Cuts the active clip at a step in two. Its controller starts again after the cut, with its first rule and
/// its timer at zero.
[[nodiscard]] Result<void> SplitClip(Document&, int step);
[[nodiscard]] Result<void> RemoveClip(Document&, int clip);
/// Inserts a copy after the clip.
[[nodiscard]] Result<void> DuplicateClip(Document&, int clip);
/// Moves a clip to index `to` among all clips.
[[nodiscard]] Result<void> ReorderClip(Document&, int clip, int to);
/// Inserts clips at a step, one after another. The clip active there continues after them. At the end of the
/// motion they are appended.
[[nodiscard]] Result<void> InsertClips(Document&, const std::vector<Stretch>& inserted, int step);
/// Repeats the whole timeline. @param times [2, 100]
[[nodiscard]] Result<void> LoopTimeline(Document&, int times);
/// Replaces a clip's controller by its mirror image, so that the figure moves the other way. Fails for
/// networks and for figures that are not their own mirror image.
[[nodiscard]] Result<void> MirrorClip(Document&, int clip);

/// Adds a controller and returns its index. An identical controller is not added again.
[[nodiscard]] Result<int> AddController(Document&, const Controller&);
/// Removes controllers that neither a clip nor the search settings use.
void DropUnusedControllers(Document&);
/// Removes unused controllers, but only those that the clips of `before` (before a change) used.
void DropUnusedControllers(Document&, std::span<const Clip> before);

}  // namespace gaitsmith
