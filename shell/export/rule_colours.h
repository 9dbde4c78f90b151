// SPDX-License-Identifier: MIT
// The ten colours of rules and controllers, for the window and for exported pictures.
#pragma once

#include <array>
#include <cstddef>

namespace gaitsmith::shell {

/// 0xRRGGBB; RuleColour in theme.h documents the choice.
inline constexpr std::array<unsigned, 10> kRuleColours = {0x2092ea, 0xdd8a53, 0x106c6f, 0x61459b, 0xeb54a9,
                                                          0xb4af0f, 0x8cb58f, 0x804538, 0x5b47e0, 0x71630f};

[[nodiscard]] constexpr unsigned RuleColourHex(int rule) {
  return kRuleColours[static_cast<std::size_t>(rule) % kRuleColours.size()];
}

}  // namespace gaitsmith::shell
