// SPDX-License-Identifier: MIT
// The values of a slider, and their positions on the track.
#pragma once

namespace gaitsmith::shell {

struct SliderRange {
  double low = 0.0;
  double high = 1.0;
  double step = 0.01;        // grid of values, and step of the arrow keys
  bool logarithmic = false;  // a logarithmic track; requires low > 0

  /// A value's position on the track, [0, 1], and the inverse.
  [[nodiscard]] double ShareOf(double value) const;
  [[nodiscard]] double ValueAt(double share) const;
  /// The nearest value on the grid.
  [[nodiscard]] double Nearest(double value) const;
  /// The value after pressing arrow keys. On a logarithmic track a key moves at least one step and at most
  /// 1/50 of the track.
  [[nodiscard]] double Stepped(double value, int steps) const;
};

}  // namespace gaitsmith::shell
