// SPDX-License-Identifier: MIT
#include "shell/widgets/slider_range.h"

#include <algorithm>
#include <cmath>

namespace gaitsmith::shell {

double SliderRange::ShareOf(double value) const {
  const double share =
      logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
  return std::clamp(share, 0.0, 1.0);
}

double SliderRange::ValueAt(double share) const {
  const double value = logarithmic ? low * std::pow(high / low, share) : low + share * (high - low);
  return Nearest(value);
}

double SliderRange::Nearest(double value) const {
  return std::clamp(std::round(value / step) * step, low, high);
}

double SliderRange::Stepped(double value, int steps) const {
  if (!logarithmic) return std::clamp(value + steps * step, low, high);
  const double moved = ValueAt(ShareOf(value) + 0.02 * steps);
  const double least = value + steps * step;
  return std::clamp(steps > 0 ? std::max(moved, least) : std::min(moved, least), low, high);
}

}  // namespace gaitsmith::shell
