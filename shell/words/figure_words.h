// SPDX-License-Identifier: MIT
// Sentences about a figure that stands and cannot move yet.
#pragma once

#include <string>
#include <string_view>

#include "core/rollout/task.h"

namespace gaitsmith::shell {

/// "This ostrich can’t move yet." @param name  a figure's
[[nodiscard]] std::string CannotMoveWords(std::string_view name);

/// What a search will do: "Teach it to run". @param name  a figure's
[[nodiscard]] const char* TeachWords(std::string_view name, TaskKind task);

}  // namespace gaitsmith::shell
