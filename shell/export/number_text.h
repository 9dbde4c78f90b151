// SPDX-License-Identifier: MIT
// Numbers as text, the same everywhere.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace gaitsmith::shell {

/// A number with this many decimals. Values that round to zero have no minus sign.
[[nodiscard]] inline std::string Decimal(double value, int decimals) {
  char text[400];  // the longest double has 309 digits
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  const std::string_view digits(text);
  return std::string(digits.find_first_not_of("-0.") == std::string_view::npos && digits[0] == '-'
                         ? digits.substr(1)
                         : digits);
}

/// A number with at most this many significant digits: 9 give back the same float, 17 the same double.
[[nodiscard]] inline std::string Digits(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value == 0.0 ? 0.0 : value);
  return text;
}

}  // namespace gaitsmith::shell
