// SPDX-License-Identifier: MIT
// The layout of a film strip: its frames, their pieces of ground, and the scale.
#pragma once

#include <vector>

#include "core/world/terrain.h"
#include "shell/export/film_strip.h"

namespace gaitsmith::shell {

/// The extent of a pose, including the thickness of rods [m].
struct PoseBounds {
  double left, right, bottom, top;
};

/// A piece of ground on the picture.
struct StripCell {
  double x, y, width, height;  // frame of the cell [px]; the height includes the captions
  double ground_y;             // where the captions begin [px]
  double left_m;               // ground coordinate at its left edge
  double level_m;              // height of the ground at ground_y, the lowest in the cell
};

struct StripLayout {
  std::vector<int> frames;       // frame of each pose
  std::vector<StripCell> cells;  // one per pose, or one for all
  double scale;                  // [px/m]
  double rod_px;                 // thickness of the rods [px]
  double tick_m;                 // distance between marks on the ground [m]
  double width, height;          // size of the picture [px]
  bool own_ground;               // each pose has its own cell

  [[nodiscard]] const StripCell& CellOf(std::size_t pose) const { return cells[own_ground ? pose : 0]; }
};

inline constexpr double kStripMargin = 32.0;   // [px]
inline constexpr double kStripHeader = 88.0;   // height of the title and the scale [px]
inline constexpr double kStripCaption = 74.0;  // below the ground: marks, letter, time [px]

[[nodiscard]] StripLayout LayOutStrip(const Motion& motion, const Terrain& ground,
                                      const FilmStripOptions& options);

/// The shortest length of 1, 2 or 5 times a power of ten metres that covers at least this many pixels [m].
[[nodiscard]] double RoundLength(double scale, double least_px);

}  // namespace gaitsmith::shell
