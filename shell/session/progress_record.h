// SPDX-License-Identifier: MIT
// How far a search is, as the page's workers report it: one record of named numbers, and the bytes that go
// with it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/numeric/error.h"
#include "shell/search/search_progress.h"

namespace gaitsmith::shell {

/// @param json  an object: "state" (of kSearchStateNames), "evaluations" and "budget" (whole numbers), "rate"
/// (evaluations per
///   second), "secondsLeft", "bestFitness" (null: none yet), "spread" (of core/document/spread_json.h, or
///   null), and how long the parts of `bytes` are: "curveBytes", "genomeBytes", "savedBytes"
/// @param bytes  the curve as core stores it (Search::CurvePoint), the best genome (16 bits a gene; no bytes:
/// as in the last
///   report) and the state of the search (Search::Save), one after another, nothing else
/// @return the progress without its number of workers; an error names the field that is wrong
[[nodiscard]] Result<SearchProgress> DecodeProgress(std::string_view json,
                                                    std::span<const std::uint8_t> bytes);

}  // namespace gaitsmith::shell
