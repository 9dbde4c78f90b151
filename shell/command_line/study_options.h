// SPDX-License-Identifier: MIT
// The study that `gaitsmith compare` was called for.
#pragma once

#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/study/study.h"

namespace gaitsmith::shell {

/// From --problem, --search, --trials, --first-seed, --evaluations, --points and what changes the problems.
/// Every search on every problem is valid.
[[nodiscard]] std::expected<Study, Refusal> ReadStudy(const Arguments&);

}  // namespace gaitsmith::shell
