// SPDX-License-Identifier: MIT
// Names in XML.
#pragma once

#include <string>
#include <string_view>

namespace gaitsmith::shell {

/// Escapes a name for XML.
[[nodiscard]] inline std::string EscapedXml(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&apos;";
        break;
      default:
        // XML does not allow most control characters.
        if (static_cast<unsigned char>(c) >= 0x20) out += c;
    }
  }
  return out;
}

}  // namespace gaitsmith::shell
