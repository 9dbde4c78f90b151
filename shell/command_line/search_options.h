// SPDX-License-Identifier: MIT
// Parameters of a search by their names in documents, for --search-option.
#pragma once

#include <string>

#include "core/search/search.h"

namespace gaitsmith::shell {

/// Sets one parameter. @param option NAME=VALUE, the name as in a document's `search` without `search.`, e.g.
/// "genetic.population=100"
[[nodiscard]] Result<void> SetSearchOption(const std::string& option, SearchSettings&);

}  // namespace gaitsmith::shell
