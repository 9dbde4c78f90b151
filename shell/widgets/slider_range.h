// SPDX-License-Identifier: MIT
// The possible numbers of a slider, and their places on the track.
#pragma once

namespace gaitsmith::shell {

struct SliderRange {
  double low = 0.0;
  double high = 1.0;
  double step = 0.01;        // for the arrow keys and for the value
  bool logarithmic = false;  // equal distances are equal ratios; low > 0

  /// A value's place on the track in [0, 1], and the inverse.
  [[nodiscard]] double ShareOf(double value) const;
  [[nodiscard]] double ValueAt(double share) const;
  /// The nearest value on the grid.
  [[nodiscard]] double Nearest(double value) const;
  /// The next value by key: on a logarithmic track at least one step, at most one fiftieth of the track.
  [[nodiscard]] double Stepped(double value, int steps) const;
};

}  // namespace gaitsmith::shell
