// SPDX-License-Identifier: MIT
// How figures travel, and sentences about a figure that stands and cannot move yet.
#pragma once

#include <string>
#include <string_view>

#include "core/rollout/task.h"

namespace gaitsmith::shell {

/// How a figure usually travels; kMove for figures that are not shipped.
enum class Gait { kMove, kRun, kHop, kCrawl, kRoll };
[[nodiscard]] Gait GaitOf(std::string_view name);

/// "This ostrich can’t move yet." @param name  a figure's
[[nodiscard]] std::string CannotMoveWords(std::string_view name);

/// What a search will do: "Teach it to run". @param name  a figure's
[[nodiscard]] const char* TeachWords(std::string_view name, TaskKind task);

}  // namespace gaitsmith::shell
