// SPDX-License-Identifier: MIT
// Runs the trials of a study on several threads and stores them as they finish, for `compare` and `suite`.
#pragma once

#include <span>
#include <string>

#include "shell/command_line/arguments.h"
#include "shell/study/study.h"

namespace gaitsmith::shell {

/// Reads --shard: I/N with I in [1, N], such as "2/8".
[[nodiscard]] Result<Shard> ReadShard(const Arguments&);

/// One of the files that a run writes.
struct StudyOutput {
  std::string path;
  StudyTable table;
};

/// Runs the shard's trials that any of the files lacks, and sorts the files. After an interruption the error
/// contains the number of trials left.
/// @param threads at least 1; does not affect the results
[[nodiscard]] Result<void> RunTrials(const Study&, std::span<const StudyOutput>, const Shard&, int threads);

}  // namespace gaitsmith::shell
