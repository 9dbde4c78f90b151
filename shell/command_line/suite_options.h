// SPDX-License-Identifier: MIT
// The study that `gaitsmith suite` was called for: every style of every task with all senses.
#pragma once

#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/study/study.h"

namespace gaitsmith::shell {

/// From --problem or --figure, --sense, --task, --style, --search, --seeds and what changes the problems.
/// Each problem is labelled SENSE.TASK.STYLE and keeps its figure's name; every trial is valid.
[[nodiscard]] std::expected<Study, Refusal> ReadSuite(const Arguments&);

}  // namespace gaitsmith::shell
