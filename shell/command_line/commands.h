// SPDX-License-Identifier: MIT
// The commands of `gaitsmith`; docs/command-line.md is the contract. Each takes its words and returns what
// went wrong.
#pragma once

#include <span>
#include <string_view>

#include "core/numeric/error.h"

namespace gaitsmith::shell {

using Words = std::span<const std::string_view>;

[[nodiscard]] Result<void> SimulateCommand(Words words);
[[nodiscard]] Result<void> SynthesizeCommand(Words words);
[[nodiscard]] Result<void> HashCommand(Words words);
[[nodiscard]] Result<void> ValidateCommand(Words words);
[[nodiscard]] Result<void> MeasureCommand(Words words);
[[nodiscard]] Result<void> LinkCommand(Words words);

}  // namespace gaitsmith::shell
