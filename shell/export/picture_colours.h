// SPDX-License-Identifier: MIT
// Colours of exported pictures, 0xrrggbb: those of the page's light and dark theme (web/page/style.css), and
// the ten of rules and controllers, which the window has, too.
#pragma once

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>

namespace gaitsmith::shell {

struct PictureColour {
  std::string_view name;
  unsigned light, dark;
};

inline constexpr PictureColour kPaperColour{"paper", 0xfbfaf6, 0x14181d};
inline constexpr PictureColour kGroundColour{"ground", 0xefebe3, 0x232a32};
inline constexpr PictureColour kInkColour{"ink", 0x1d2733, 0xe8e6e1};
/// Of limbs on the far side: 57 % ink on paper, as on the stage.
inline constexpr PictureColour kFarColour{"far", 0x7c8287, 0x8d8d8d};
inline constexpr PictureColour kLineColour{"line", 0x5b6672, 0x98a2ad};

inline constexpr std::array kPictureColours = {kPaperColour, kGroundColour, kInkColour, kFarColour,
                                               kLineColour};

/// RuleColour in theme.h documents the choice.
inline constexpr std::array<unsigned, 10> kRuleColours = {0x2092ea, 0xdd8a53, 0x106c6f, 0x61459b, 0xeb54a9,
                                                          0xb4af0f, 0x8cb58f, 0x804538, 0x5b47e0, 0x71630f};

[[nodiscard]] constexpr unsigned RuleColourHex(int rule) {
  return kRuleColours[static_cast<std::size_t>(rule) % kRuleColours.size()];
}

[[nodiscard]] inline std::string HexColour(unsigned colour) {
  char text[8];
  std::snprintf(text, sizeof text, "#%06x", colour & 0xffffffu);
  return text;
}

}  // namespace gaitsmith::shell
