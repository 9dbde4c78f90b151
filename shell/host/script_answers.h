// SPDX-License-Identifier: MIT
// What scripts on the page are told of queue and results (docs/embedding.md), as JSON lists.
#pragma once

#include <string>

#include "shell/session/found_motions.h"
#include "shell/session/search_queue.h"
#include "shell/session/session.h"

namespace gaitsmith::shell {

/// The next one first: {"title", "algorithm", "seed", "evaluations"}.
[[nodiscard]] std::string QueueJson(const SearchQueue&);
/// The newest first: {"id", "title", "origin", "score", "algorithm", "seed", "evaluations", "kept", "when",
/// "hash", "link"}; "score" is null where there is none, "link" a payload.
[[nodiscard]] std::string FoundJson(const FoundMotions&);

/// The whole motion in numbers: {"terms": [{"name", "label", "unit", "decimals", "value"}], "sense", "rules",
/// "broke"}. The terms are "distance", which is |travel|, "travel", and those of Table 3 and docs/style.md;
/// "sense" is "physical", "timer", "network" or, without a controller, empty; "broke" says that physics did,
/// and then nothing counts.
[[nodiscard]] std::string MeasuresJson(const Session&);

}  // namespace gaitsmith::shell
