// SPDX-License-Identifier: MIT
// Decodes a search's progress as the page's workers report it: JSON, and bytes.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/numeric/error.h"
#include "shell/search/search_progress.h"

namespace gaitsmith::shell {

/// @param json  an object: "state" (of kSearchStateNames), "evaluations" and "budget" (whole numbers), "rate"
/// (evaluations per second), "secondsLeft", "bestFitness" (null: none yet), "spread" (of
/// core/document/spread_json.h, or null), and the lengths of the parts of `bytes`: "curveBytes",
/// "genomeBytes", "savedBytes"
/// @param bytes  exactly these parts in order: the curve as core stores it (Search::CurvePoint), the best
/// genome (16 bits a gene; empty: as in the last report) and the state of the search (Search::Save)
/// @return the progress without its number of workers; an error names the wrong field
[[nodiscard]] Result<SearchProgress> DecodeProgress(std::string_view json,
                                                    std::span<const std::uint8_t> bytes);

}  // namespace gaitsmith::shell
