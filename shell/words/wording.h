// SPDX-License-Identifier: MIT
// Numbers and names as people read them. (Our compilers' standard library has no std::format yet.)
#pragma once

#include <cstddef>
#include <string>

namespace gaitsmith::shell {

/// With a point, whatever the language: for what is stored.
[[nodiscard]] std::string PlainFixed(double value, int decimals);
[[nodiscard]] std::string Fixed(double value, int decimals);
[[nodiscard]] std::string Fixed(float value, int decimals);
/// "13,600"
[[nodiscard]] std::string Grouped(long long value);
/// "2 s", "1 min 20 s", "3 h"
[[nodiscard]] std::string Duration(double seconds);
/// At most so many bytes of UTF-8 text, at least 3; what is cut off leaves an ellipsis.
[[nodiscard]] std::string Shortened(const std::string& text, std::size_t bytes);

}  // namespace gaitsmith::shell
