// SPDX-License-Identifier: MIT
// The commands of `gaitsmith`; docs/command-line.md is the contract. Each takes its words and returns why it
// refused.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/numeric/error.h"

namespace gaitsmith::shell {

using Words = std::span<const std::string_view>;

/// Why a command refused, and the exit status that tells scripts.
struct Refusal {
  Refusal(Error fault, int exit_status = 1)  // implicit: most refusals are just an error
      : error(std::move(fault)), status(exit_status) {}
  Error error;
  int status;  // 1, or 2 for a wrong call
};
using Outcome = std::expected<void, Refusal>;

/// The call itself is wrong: no file could make it right.
[[nodiscard]] inline std::unexpected<Refusal> WrongCall(Error error) {
  return std::unexpected(Refusal(std::move(error), 2));
}

[[nodiscard]] Outcome SimulateCommand(Words words);
[[nodiscard]] Outcome ExportCommand(Words words);
[[nodiscard]] Outcome SynthesizeCommand(Words words);
[[nodiscard]] Outcome CompareCommand(Words words);
[[nodiscard]] Outcome SuiteCommand(Words words);
[[nodiscard]] Outcome MergeCommand(Words words);
[[nodiscard]] Outcome SwitchesCommand(Words words);
[[nodiscard]] Outcome HashCommand(Words words);
[[nodiscard]] Outcome ValidateCommand(Words words);
[[nodiscard]] Outcome MeasureCommand(Words words);
[[nodiscard]] Outcome LinkCommand(Words words);
[[nodiscard]] Outcome CatalogueCommand(Words words);

/// What `compare --summary` prints of a file of results.
[[nodiscard]] Outcome Summarize(const std::string& path);

}  // namespace gaitsmith::shell
