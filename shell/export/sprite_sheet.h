// SPDX-License-Identifier: MIT
// What a sprite sheet may be asked for.
#pragma once

namespace gaitsmith::shell {

struct SpriteOptions {
  static constexpr int kLeastFrames = 2, kMostFrames = 256;
  static constexpr int kLeastSize = 16, kMostSize = 1024;          // [px]
  static constexpr double kLeastScale = 1.0, kMostScale = 1000.0;  // [px/m]
  static constexpr double kMostPixels = 1 << 24;                   // of a sheet: 64 MB while it is made
  static constexpr int kMostSheet = 8192;  // width and height that game engines still read [px]

  int frames = 16;     // at equal intervals; of a whole motion including both ends
  int size = 128;      // the longer side of a frame [px]
  double scale = 0.0;  // in place of the size, if not 0 [px/m]: then figures fit one another
};

}  // namespace gaitsmith::shell
