// SPDX-License-Identifier: MIT
// A motion as a lettered film strip in SVG, for print, as in the paper's Figures 8 to 12.
#pragma once

#include <string>

#include "core/document/document.h"

namespace gaitsmith::shell {

inline constexpr int kMinPoses = 3;
inline constexpr int kMaxPoses = 26;  // one per letter

/// The texts on a film strip, which callers may translate.
struct FilmStripWords {
  /// For screen readers: number of poses, figure, first and last time [s], first and last letter.
  std::string description = "{1} poses of {2} from {3} s to {4} s, lettered {5} to {6}.";
  /// Tilt of the ground, counterclockwise [degrees]. The ground is drawn level.
  std::string slope = "ground tilted by {1}°, drawn level";
  std::string decimal_mark = ".";
};

struct FilmStripOptions {
  int poses = 8;        // [kMinPoses, kMaxPoses], at equal intervals including both ends
  double from_s = 0.0;  // clamped to the motion
  double to_s = 1e9;    // not before from_s
  FilmStripWords words = {};
};

/// Draws poses at their true positions if they do not overlap, else each on a separate piece of ground.
/// @param motion of the document
[[nodiscard]] std::string FilmStripSvg(const Document& document, const Motion& motion,
                                       const FilmStripOptions& options);

}  // namespace gaitsmith::shell
