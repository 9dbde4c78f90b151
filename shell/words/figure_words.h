// SPDX-License-Identifier: MIT
// How figures travel, and sentences about a figure that stands and cannot move yet.
#pragma once

#include <string>
#include <string_view>

#include "core/document/document.h"

namespace gaitsmith::shell {

/// How a figure usually travels; kMove for figures that are not shipped.
enum class Gait { kMove, kRun, kHop, kCrawl, kRoll };
[[nodiscard]] Gait GaitOf(std::string_view name);

/// "This ostrich can’t move yet." @param name  a figure's
[[nodiscard]] std::string CannotMoveWords(std::string_view name);

/// What the document's search will do: "Teach it to run".
[[nodiscard]] const char* TeachWords(const Document&);

}  // namespace gaitsmith::shell
