// SPDX-License-Identifier: MIT
// The panels in the order of View::panel. On a phone the timeline is the last of them.
#pragma once

#include <array>
#include <string_view>

namespace gaitsmith::shell {

inline constexpr std::array<std::string_view, 6> kPanels = {"Figure", "Controller", "Style",
                                                            "Search", "Lab",        "Timeline"};
inline constexpr int kDeskPanels = 5;
inline constexpr int kTimelinePanel = 5;

}  // namespace gaitsmith::shell
