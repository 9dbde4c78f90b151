// SPDX-License-Identifier: MIT
// The study that `gaitsmith compare` was called for, and what `suite` reads likewise.
#pragma once

#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/study/study.h"

namespace gaitsmith::shell {

/// A search by its label, such as "ssga:genetic.rates=per-component"; the plan's evaluations are set already.
[[nodiscard]] Result<void> AddSearch(const std::string& label, Study&);
/// A problem whose label is new. The figure's name and the title stay, if they matter.
/// @param option for the error
[[nodiscard]] Result<void> AddProblem(const std::string& label, Document problem, const char* option, Study&);

/// --first-seed and --evaluations. @param seeds the option that says how many of them
[[nodiscard]] Result<void> ReadSeeds(const Arguments&, const char* seeds, StudyPlan&);

/// From --problem, --search, --trials, --first-seed, --evaluations, --points and what changes the problems.
/// Every search on every problem is valid.
[[nodiscard]] std::expected<Study, Refusal> ReadStudy(const Arguments&);

}  // namespace gaitsmith::shell
