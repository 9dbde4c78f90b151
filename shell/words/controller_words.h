// SPDX-License-Identifier: MIT
// Controllers and tasks in a few words.
#pragma once

#include <string>

#include "core/document/document.h"

namespace gaitsmith::shell {

/// "10 rules with physical senses", "10 rules with timer 0.80 s", "a network of 10 hidden nodes",
/// "a trajectory of 10 knots".
[[nodiscard]] std::string ControllerWords(ControllerKind, const SenseSpec&, int rules);
/// As ControllerWords, but always in English, as stored in files and links.
[[nodiscard]] std::string ControllerName(ControllerKind, const SenseSpec&, int rules);
/// What the task rewards, e.g. "travel".
[[nodiscard]] std::string TaskWords(TaskKind);
/// As TaskWords, but always in English.
[[nodiscard]] const char* TaskName(TaskKind);

}  // namespace gaitsmith::shell
