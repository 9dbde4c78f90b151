// SPDX-License-Identifier: MIT
// One trial of a study.
#pragma once

#include <atomic>
#include <functional>

#include "shell/study/study.h"

namespace gaitsmith::shell {

/// Runs a trial on the calling thread. The result depends only on the study and the trial.
/// @param trial index below plan.Total()
/// @param tables the tables to return rows for
/// @param evaluations increased while the trial runs
/// @param stop  polled often; true aborts the trial
/// @return the trial's rows for each table; nothing if it was aborted
[[nodiscard]] std::optional<std::vector<std::string>> RunTrial(const Study&, std::size_t trial,
                                                               std::span<const StudyTable> tables,
                                                               std::atomic<std::int64_t>& evaluations,
                                                               const std::function<bool()>& stop);

}  // namespace gaitsmith::shell
