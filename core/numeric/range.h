// SPDX-License-Identifier: MIT
// Whether a number is in its range, and the words that say that it is not.
#pragma once

#include <cmath>
#include <string>

#include "core/numeric/error.h"

namespace gaitsmith {

/// A number to six places, without zeros at its end.
[[nodiscard]] inline std::string NumberText(float number) {
  std::string text = std::to_string(number);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

/// @param where the fault is, such as "rods[2].length_m"
[[nodiscard]] inline Result<void> CheckRange(float value, float low, float high, const std::string& where) {
  if (!std::isfinite(value)) return Fail(ErrorCode::kNotFinite, where, "must be a finite number");
  if (value < low || value > high) {
    return Fail(ErrorCode::kOutOfRange, where,
                "must be from " + NumberText(low) + " to " + NumberText(high) + ", is " + NumberText(value));
  }
  return {};
}

}  // namespace gaitsmith
