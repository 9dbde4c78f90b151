// SPDX-License-Identifier: MIT
// The command-line options that change a problem: duration, senses, controller and style.
#pragma once

#include "core/document/document.h"
#include "shell/command_line/arguments.h"

namespace gaitsmith::shell {

/// Parses the value of --sense: "physical", "timer=SECONDS", "sight" or "sight=RODS", which
/// looks to the left if it is negative.
[[nodiscard]] Result<void> SetSense(const std::string& text, SenseSpec&);
/// The inverse of SetSense.
[[nodiscard]] std::string SenseText(const SenseSpec&);

/// Sets the weight of one style term: a number, or "usual" or "gentle" for a weight calibrated for the
/// document's figure and senses, "-usual" or "-gentle" to ask for less. @param where for the error, if the
/// weight is not a number
[[nodiscard]] Result<void> SetWeight(const std::string& term, const std::string& weight, Document&,
                                     const std::string& option, const std::string& where);

/// Converts seconds to steps. @param least, most the valid range [steps]
[[nodiscard]] Result<int> WholeSteps(const std::string& seconds, const std::string& where, int least,
                                     int most = kMaxSteps);

/// Applies --duration, --sense, --controller and --weight, as far as given. Checks each option by itself;
/// Validate checks the document.
[[nodiscard]] Result<void> SetProblemOptions(const Arguments&, Document&);

}  // namespace gaitsmith::shell
