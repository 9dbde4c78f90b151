// SPDX-License-Identifier: MIT
// A study that can be run: its plan, and the problems and searches that the plan names.
#pragma once

#include <atomic>
#include <functional>

#include "core/document/document.h"
#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/study_file.h"

namespace gaitsmith::shell {

struct Study {
  StudyPlan plan;
  /// Each document holds its problem alone, and the controller to start from if its search asks for one.
  std::vector<Document> problems;
  std::vector<SearchSettings> searches;  // but for `seed` and `start`
};

/// From --problem, --search, --trials, --first-seed, --evaluations, --points and what changes the problems.
/// Every search on every problem is valid.
[[nodiscard]] std::expected<Study, Refusal> ReadStudy(const Arguments&);

/// A trial's rows for both files.
struct TrialRows {
  std::string result, curve;
};
/// Runs a trial on the calling thread, to its end. The result depends on the study alone.
/// @param trial index below plan.Total()
/// @param evaluations counts on while the trial runs
/// @param stop  asked often; true gives the trial up
/// @return nothing if it was given up
[[nodiscard]] std::optional<TrialRows> RunTrial(const Study&, std::size_t trial,
                                                std::atomic<std::int64_t>& evaluations,
                                                const std::function<bool()>& stop);

}  // namespace gaitsmith::shell
