// SPDX-License-Identifier: MIT
// Parses the options that scripts on the page pass as JSON objects (docs/embedding.md).
#pragma once

#include <string>

#include "core/document/document.h"
#include "core/document/json_value.h"
#include "shell/results/lab.h"
#include "shell/workspace/arrangement.h"

namespace gaitsmith::shell {

/// Options of a search, each optional: {"algorithm": "sphc", "evaluations": 40000, "seed": 1, "workers": 2,
/// "sense": "physical" | "timer", "period": 0.8}. The document is not validated.
/// @return an empty text, or a sentence
[[nodiscard]] std::string ApplySearchOptions(const JsonValue& options, Document& document, int& workers);

/// Options of the lab, each optional: {"algorithms": ["sphc", "rgt"], "trials": 10, "evaluations": 4000,
/// "firstSeed": 1}. The lab checks their ranges.
/// @return an empty text, or a sentence
[[nodiscard]] std::string ApplyLabOptions(const JsonValue& options, LabSettings& settings);

/// The panels that a lesson shows, the parts that it locks, and whether Live is on, each optional: {"panels":
/// "style,search", "lock": "figure", "live": "off"}.
/// @return an empty text, or a sentence, with nothing changed
[[nodiscard]] std::string ApplyArrangement(const JsonValue& options, Arrangement& arrangement);

}  // namespace gaitsmith::shell
