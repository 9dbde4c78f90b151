// SPDX-License-Identifier: MIT
// Where everything on a film strip stands: which instants are shown, on which piece of ground, how large.
#pragma once

#include <vector>

#include "shell/export/film_strip.h"

namespace gaitsmith::shell {

/// What a pose takes up, rods' thickness included [m].
struct PoseBounds {
  double left, right, bottom, top;
};

/// A piece of ground on the picture.
struct StripCell {
  double x, y, width, height;  // its frame [px]; height ends where the captions do
  double ground_y;             // [px]
  double left_m;               // what lies at its left edge
};

struct StripLayout {
  std::vector<int> frames;       // of the motion
  std::vector<StripCell> cells;  // one for each of them, or one for all
  double scale;                  // [px/m]
  double rod_px;                 // thickness of the rods
  double tick_m;                 // between marks on the ground
  double width, height;          // of the picture [px]
  bool own_ground;               // each pose has its own cell

  [[nodiscard]] const StripCell& CellOf(std::size_t pose) const { return cells[own_ground ? pose : 0]; }
};

inline constexpr double kStripMargin = 32.0;   // [px]
inline constexpr double kStripHeader = 88.0;   // height of title and scale [px]
inline constexpr double kStripCaption = 74.0;  // below the ground: marks, letter, time [px]

[[nodiscard]] StripLayout LayOutStrip(const Motion& motion, const FilmStripOptions& options);

/// The length of 1, 2 or 5 times a power of ten metres that is at least so long on the picture [m].
[[nodiscard]] double RoundLength(double scale, double least_px);

}  // namespace gaitsmith::shell
