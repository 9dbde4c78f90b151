// SPDX-License-Identifier: MIT
// The spread of a population as JSON. The field names are defined only here.
#pragma once

#include <optional>
#include <string>

#include "core/document/json_value.h"
#include "core/search/spread.h"

namespace gaitsmith {

/// {"members":10,"least":…,"lowerQuartile":…,"median":…,"upperQuartile":…,"best":…}, with exact floats.
[[nodiscard]] std::string SpreadJson(const Spread&);
/// @return nothing if a number is missing, or `members` is not a whole number of at least 2
[[nodiscard]] std::optional<Spread> SpreadFromJson(const JsonValue&);

}  // namespace gaitsmith
