// SPDX-License-Identifier: MIT
// The panels in the order of View::panel. On a phone the timeline is the last of them.
#pragma once

#include <array>

#include "shell/words/language.h"

namespace gaitsmith::shell {

inline constexpr std::array<const char*, 6> kPanels = {TrLater("Figure"), TrLater("Controller"),
                                                       TrLater("Style"),  TrLater("Search"),
                                                       TrLater("Lab"),    TrLater("Timeline")};
inline constexpr int kDeskPanels = 5;
inline constexpr int kTimelinePanel = 5;

}  // namespace gaitsmith::shell
