// SPDX-License-Identifier: MIT
// Search parameters by their names in documents, for --search-option.
#pragma once

#include <string>

#include "core/search/search.h"

namespace gaitsmith::shell {

/// Sets one parameter. @param option NAME=VALUE, with the parameter's path below the document's `search`,
/// such as "genetic.population=100"
[[nodiscard]] Result<void> SetSearchOption(const std::string& option, SearchSettings&);

}  // namespace gaitsmith::shell
