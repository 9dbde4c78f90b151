// SPDX-License-Identifier: MIT
// Numbers to text.
#include "shell/words/wording.h"

#include <cmath>
#include <cstdio>

#include "shell/words/language.h"

namespace gaitsmith::shell {

std::string PlainFixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  // Drop the sign of a rounded "-0.0".
  bool zero = text[0] == '-';
  for (const char* c = text + 1; zero && *c != '\0'; ++c) zero = *c == '0' || *c == '.';
  return zero ? text + 1 : text;
}

std::string Fixed(double value, int decimals) {
  std::string text = PlainFixed(value, decimals);
  if (const std::size_t point = text.find('.'); point != std::string::npos)
    text.replace(point, 1, DecimalMark());
  if (text.front() == '-') text.replace(0, 1, kMinus);
  return text;
}

std::string Fixed(float value, int decimals) { return Fixed(static_cast<double>(value), decimals); }

std::string Grouped(long long value) {
  std::string text = std::to_string(std::abs(value));
  for (int at = static_cast<int>(text.size()) - 3; at > 0; at -= 3) {
    text.insert(static_cast<std::size_t>(at), GroupMark());
  }
  return value < 0 ? std::string(kMinus) + text : text;
}

std::string Duration(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(seconds));
  if (whole < 90) return Grouped(whole) + " s";
  if (whole < 5400)
    return Grouped(whole / 60) + " min" + (whole % 60 != 0 ? " " + Grouped(whole % 60) + " s" : "");
  return Grouped((whole + 1800) / 3600) + " h";
}

std::string Shortened(const std::string& text, std::size_t bytes) {
  static const std::string kEllipsis = "…";
  if (text.size() <= bytes) return text;
  std::size_t end = bytes - kEllipsis.size();
  // Bytes 10xxxxxx continue a character.
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0u) == 0x80u) --end;
  return text.substr(0, end) + kEllipsis;
}

}  // namespace gaitsmith::shell
