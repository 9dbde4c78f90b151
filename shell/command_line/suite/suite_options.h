// SPDX-License-Identifier: MIT
// Builds the study of `gaitsmith suite` from its options: every combination of senses, task and style.
#pragma once

#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/study/study.h"

namespace gaitsmith::shell {

/// Reads --problem or --figure, --sense, --task, --style, --search, --seeds and the options that change
/// problems. Each problem is labelled SENSE.TASK.STYLE and keeps its figure's name. Every trial is valid.
[[nodiscard]] std::expected<Study, Refusal> ReadSuite(const Arguments&);

}  // namespace gaitsmith::shell
