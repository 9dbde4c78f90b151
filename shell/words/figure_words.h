// SPDX-License-Identifier: MIT
// Sentences about a figure that stands and cannot move yet.
#pragma once

#include <string>
#include <string_view>

#include "core/document/document.h"

namespace gaitsmith::shell {

/// "This ostrich can’t move yet." @param name  a figure's
[[nodiscard]] std::string CannotMoveWords(std::string_view name);

/// What the document's search will do: "Teach it to run".
[[nodiscard]] const char* TeachWords(const Document&);

}  // namespace gaitsmith::shell
