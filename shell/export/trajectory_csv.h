// SPDX-License-Identifier: MIT
// A motion as CSV: one row per step, including the start. docs/command-line.md documents the columns.
#pragma once

#include <string>

#include "core/document/document.h"

namespace gaitsmith::shell {

/// @param motion of the document
[[nodiscard]] std::string TrajectoryCsv(const Document& document, const Motion& motion);

}  // namespace gaitsmith::shell
