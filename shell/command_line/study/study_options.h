// SPDX-License-Identifier: MIT
// Builds the study of `gaitsmith compare` from its options. `suite` shares parts of it.
#pragma once

#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/study/study.h"

namespace gaitsmith::shell {

/// Adds a search by its label, such as "ssga:genetic.rates=per-component". Set the plan's evaluations first.
[[nodiscard]] Result<void> AddSearch(const std::string& label, Study&);
/// Adds a problem with a unique label, and keeps its title and figure name. @param option for the error
[[nodiscard]] Result<void> AddProblem(const std::string& label, Document problem, const char* option, Study&);

/// Reads --first-seed, --evaluations and the number of seeds. @param seeds the option with that number
[[nodiscard]] Result<void> ReadSeeds(const Arguments&, const char* seeds, StudyPlan&);

/// Reads --problem, --search, --trials, --first-seed, --evaluations, --points and the options that change
/// problems. In the result every search is valid on every problem.
[[nodiscard]] std::expected<Study, Refusal> ReadStudy(const Arguments&);

}  // namespace gaitsmith::shell
