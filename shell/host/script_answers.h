// SPDX-License-Identifier: MIT
// JSON for scripts on the page about queue, results and motion (docs/embedding.md).
#pragma once

#include <string>

#include "shell/results/found_motions.h"
#include "shell/results/search_queue.h"
#include "shell/session/session.h"

namespace gaitsmith::shell {

/// A list, the next search first: {"title", "algorithm", "seed", "evaluations"}.
[[nodiscard]] std::string QueueJson(const SearchQueue&);
/// A list, the newest first: {"id", "title", "origin", "score", "algorithm", "seed", "evaluations", "kept",
/// "when", "hash", "link"}; "score" is null if there is none, "link" is a payload.
[[nodiscard]] std::string FoundJson(const FoundMotions&);

/// The numbers of the whole motion: {"terms": [{"name", "label", "unit", "decimals", "value"}], "sense",
/// "controller", "world", "rules", "broke", "preview"}. The terms are "distance", which is |travel|,
/// "travel", those of Table 3 and docs/style.md, and those of docs/embedding.md that are no terms of a score;
/// "value" is null if the motion has none. "controller" is as of Provenance::Of, "world" is "usual" or
/// "other". "sense" is "physical", "timer", "network" or, without a controller, empty. "broke" is true if the
/// motion broke physics, and then no term is valid.
[[nodiscard]] std::string MeasuresJson(const Session&);

}  // namespace gaitsmith::shell
