// SPDX-License-Identifier: MIT
// The lettered film strip of a motion, as the paper's Figures 8 to 12 have it, for a page that is printed:
// SVG.
#pragma once

#include <string>

#include "core/document/document.h"

namespace gaitsmith::shell {

inline constexpr int kFewestPoses = 3;
inline constexpr int kMostPoses = 26;  // one for each letter

/// What is written on it besides names and numbers.
struct FilmStripWords {
  /// For who cannot see it: how many poses, of what figure, from and to when [s], first and last letter.
  std::string description = "{1} poses of {2} from {3} s to {4} s, lettered {5} to {6}.";
  /// How steep the ground is, anticlockwise [degrees]: it is drawn level.
  std::string slope = "ground tilted by {1}°, drawn level";
  std::string decimal_mark = ".";
};

struct FilmStripOptions {
  int poses = 8;        // [kFewestPoses, kMostPoses]; evenly in time, the first and last instant included
  double from_s = 0.0;  // what lies outside the motion is moved to its ends
  double to_s = 1e9;    // not before from_s
  FilmStripWords words = {};
};

/// Poses stand where the figure was where that leaves them apart, else each on a piece of ground of its own.
/// @param motion of the document
[[nodiscard]] std::string FilmStripSvg(const Document& document, const Motion& motion,
                                       const FilmStripOptions& options);

}  // namespace gaitsmith::shell
