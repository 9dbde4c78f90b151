// SPDX-License-Identifier: MIT
// One trial of a study, on the thread that calls.
#pragma once

#include <atomic>
#include <functional>

#include "shell/study/study.h"

namespace gaitsmith::shell {

/// Runs a trial on the calling thread, to its end. The result depends on the study alone.
/// @param trial index below plan.Total()
/// @param tables whose rows are wanted
/// @param evaluations counts on while the trial runs
/// @param stop  asked often; true gives the trial up
/// @return its rows in each of the tables; nothing if it was given up
[[nodiscard]] std::optional<std::vector<std::string>> RunTrial(const Study&, std::size_t trial,
                                                               std::span<const StudyTable> tables,
                                                               std::atomic<std::int64_t>& evaluations,
                                                               const std::function<bool()>& stop);

}  // namespace gaitsmith::shell
