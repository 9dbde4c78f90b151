// SPDX-License-Identifier: MIT
// Numbers and names as text. (Our compilers' standard library has no std::format yet.)
#pragma once

#include <cstddef>
#include <string>

namespace gaitsmith::shell {

/// With a decimal point in every language, for stored text.
[[nodiscard]] std::string PlainFixed(double value, int decimals);
[[nodiscard]] std::string Fixed(double value, int decimals);
[[nodiscard]] std::string Fixed(float value, int decimals);
/// "13,600"
[[nodiscard]] std::string Grouped(long long value);
/// "2 s", "1 min 20 s", "3 h"
[[nodiscard]] std::string Duration(double seconds);
/// The text in at most this many bytes of UTF-8, at least 3; an ellipsis replaces what is cut off.
[[nodiscard]] std::string Shortened(const std::string& text, std::size_t bytes);

}  // namespace gaitsmith::shell
