// SPDX-License-Identifier: MIT
// What is in a file that `gaitsmith suite` wrote, finished or not.
#pragma once

#include <string>

#include "shell/command_line/commands.h"

namespace gaitsmith::shell {

/// Prints a table for people: by label, the best first.
[[nodiscard]] Outcome ListSuite(const std::string& path);

enum class Extracted {
  kAll,
  kBest,  // of each label
};
/// Writes documents as LABEL-SEED.json into a folder, which is made if need be.
[[nodiscard]] Outcome ExtractSuite(const std::string& path, const std::string& folder, Extracted which);

}  // namespace gaitsmith::shell
