// SPDX-License-Identifier: MIT
// Names controllers by what they do. Searches give their clips these names.
#pragma once

#include <span>
#include <string>

#include "core/document/document.h"

namespace gaitsmith::shell {

/// "Run left", "Jump", "Stand": what a controller does alone from the document's start. Always in English, as
/// stored in documents; TrTitle translates it. Empty if the simulation fails.
/// @param others if another one of these has the same name, the distance is added: "Run left, 17 m"
[[nodiscard]] std::string MotionName(const Document&, int controller,
                                     std::span<const Controller> others = {});

}  // namespace gaitsmith::shell
