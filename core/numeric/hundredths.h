// SPDX-License-Identifier: MIT
// Numbers in sentences: core does not print, so it has no formats.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

namespace gaitsmith {

/// "0.04", "12.30": a number of at most a million, rounded to hundredths. @param number at least 0
[[nodiscard]] inline std::string InHundredths(double number) {
  const auto hundredths = static_cast<int>(std::lround(std::min(number, 1e6) * 100.0));
  std::string text = std::to_string(hundredths / 100);
  text += hundredths % 100 < 10 ? ".0" : ".";
  text += std::to_string(hundredths % 100);
  return text;
}

}  // namespace gaitsmith
