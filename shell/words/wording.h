// SPDX-License-Identifier: MIT
// Numbers and names as text. The standard libraries of the supported compilers lack std::format.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace gaitsmith::shell {

inline constexpr std::string_view kMinus = "−";

/// Always with a decimal point, for stored text.
[[nodiscard]] std::string PlainFixed(double value, int decimals);
/// As people read it: the language's decimal mark, and a minus sign of a digit's width.
[[nodiscard]] std::string Fixed(double value, int decimals);
[[nodiscard]] std::string Fixed(float value, int decimals);
/// "13,600"
[[nodiscard]] std::string Grouped(long long value);
/// "2 s", "1 min 20 s", "3 h"
[[nodiscard]] std::string Duration(double seconds);
/// The text in at most `bytes` bytes of UTF-8, with an ellipsis if it was cut. @param bytes at least 3
[[nodiscard]] std::string Shortened(const std::string& text, std::size_t bytes);

}  // namespace gaitsmith::shell
