// SPDX-License-Identifier: MIT
// The trials of a study on several threads, kept in files as they finish: what `compare` and `suite` share.
#pragma once

#include <span>
#include <string>

#include "shell/command_line/arguments.h"
#include "shell/study/study.h"

namespace gaitsmith::shell {

struct Shard {
  std::size_t first = 0, of = 1;  // every of-th trial, from the first on
};
/// --shard: "2/8", from 1/n to n/n.
[[nodiscard]] Result<Shard> ReadShard(const Arguments&);

/// One of the files that a run writes.
struct StudyOutput {
  std::string path;
  StudyTable table;
};

/// Runs the shard's trials that not all files have yet, and puts the files in order. After an interruption
/// the error says how many trials are left.
/// @param threads at least 1; changes the time alone
[[nodiscard]] Result<void> RunTrials(const Study&, std::span<const StudyOutput>, const Shard&, int threads);

}  // namespace gaitsmith::shell
