// SPDX-License-Identifier: MIT
// Reads the parts of headings and rows.
#pragma once

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>
#include <vector>

namespace gaitsmith::shell {

/// The parts between marks; at least one.
[[nodiscard]] inline std::vector<std::string> PartsOf(std::string_view text, char mark) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(mark, at), text.size());
    parts.emplace_back(text.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

/// @return whether the whole text is a number that fits
template <class Whole>
[[nodiscard]] bool ReadWhole(std::string_view text, Whole& value) {
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc{} && end == text.data() + text.size();
}

}  // namespace gaitsmith::shell
