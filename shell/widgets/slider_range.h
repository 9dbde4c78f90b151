// SPDX-License-Identifier: MIT
// The numbers a slider can stand at, and where.
#pragma once

namespace gaitsmith::shell {

struct SliderRange {
  double low = 0.0;
  double high = 1.0;
  double step = 0.01;        // of the arrow keys and of the value itself
  bool logarithmic = false;  // equal distances are equal ratios; low > 0

  /// Where a value stands on its track, in [0, 1], and back.
  [[nodiscard]] double ShareOf(double value) const;
  [[nodiscard]] double ValueAt(double share) const;
  /// The value on its grid that is nearest to this one.
  [[nodiscard]] double Nearest(double value) const;
  /// The next value by key: on a logarithmic track at least one step, at most one fiftieth of the track.
  [[nodiscard]] double Stepped(double value, int steps) const;
};

}  // namespace gaitsmith::shell
