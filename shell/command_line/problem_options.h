// SPDX-License-Identifier: MIT
// What a command's options change about a problem: how long, with which senses and controller, in which
// style.
#pragma once

#include "core/document/document.h"
#include "shell/command_line/arguments.h"

namespace gaitsmith::shell {

/// Sets what --duration, --sense, --controller and --weight name and leaves the rest. Numbers that fit their
/// options but no document are for Validate to find.
[[nodiscard]] Result<void> SetProblemOptions(const Arguments&, Document&);

}  // namespace gaitsmith::shell
