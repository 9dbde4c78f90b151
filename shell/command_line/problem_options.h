// SPDX-License-Identifier: MIT
// What a command's options change about a problem: how long, with which senses and controller, in which
// style.
#pragma once

#include "core/document/document.h"
#include "shell/command_line/arguments.h"

namespace gaitsmith::shell {

/// "physical" or "timer=SECONDS", as --sense takes it.
[[nodiscard]] Result<void> SetSense(const std::string& text, SenseSpec&);
/// The text that says so.
[[nodiscard]] std::string SenseText(const SenseSpec&);

/// The weight of one style term: a number, or "usual" for the one calibrated for the document's figure and
/// senses. @param where for the error, if it is no number
[[nodiscard]] Result<void> SetWeight(const std::string& term, const std::string& weight, Document&,
                                     const std::string& option, const std::string& where);

/// A time that is given in seconds. @param least, most [steps]
[[nodiscard]] Result<int> WholeSteps(const std::string& seconds, const std::string& where, int least,
                                     int most = kMaxSteps);

/// Sets what --duration, --sense, --controller and --weight name and leaves the rest. Numbers that fit their
/// options but no document are for Validate to find.
[[nodiscard]] Result<void> SetProblemOptions(const Arguments&, Document&);

}  // namespace gaitsmith::shell
