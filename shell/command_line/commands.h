// SPDX-License-Identifier: MIT
// The commands of `gaitsmith`, as specified in docs/command-line.md. Each takes the words after its name.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/numeric/error.h"

namespace gaitsmith::shell {

using Words = std::span<const std::string_view>;

/// Why a command failed, with its exit status.
struct Refusal {
  Refusal(Error fault, int exit_status = 1)  // implicit: most refusals are just an error
      : error(std::move(fault)), status(exit_status) {}
  Error error;
  int status;  // 1, or 2 for a usage error
};
using Outcome = std::expected<void, Refusal>;

/// A usage error: the call is wrong whatever the files contain.
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
[[nodiscard]] Outcome NewCommand(Words words);
[[nodiscard]] Outcome GoalsCommand(Words words);
[[nodiscard]] Outcome BreedCommand(Words words);
[[nodiscard]] Outcome TasteCommand(Words words);
[[nodiscard]] Outcome HashCommand(Words words);
[[nodiscard]] Outcome ValidateCommand(Words words);
[[nodiscard]] Outcome MeasureCommand(Words words);
[[nodiscard]] Outcome SensesCommand(Words words);
[[nodiscard]] Outcome PlanCommand(Words words);
[[nodiscard]] Outcome RecordCommand(Words words);
[[nodiscard]] Outcome LoopCommand(Words words);
[[nodiscard]] Outcome LinkCommand(Words words);
[[nodiscard]] Outcome CatalogueCommand(Words words);

}  // namespace gaitsmith::shell
