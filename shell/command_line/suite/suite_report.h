// SPDX-License-Identifier: MIT
// Reports on a file that `gaitsmith suite` wrote, complete or not.
#pragma once

#include <string>

#include "shell/command_line/commands.h"

namespace gaitsmith::shell {

/// Prints a readable table, sorted by label, then best first.
[[nodiscard]] Outcome ListSuite(const std::string& path);

enum class Extracted {
  kAll,
  kBest,  // the best of each label
};
/// Writes documents as LABEL-SEED.json into a folder, which is created if needed.
[[nodiscard]] Outcome ExtractSuite(const std::string& path, const std::string& folder, Extracted which);

}  // namespace gaitsmith::shell
