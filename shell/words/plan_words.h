// SPDX-License-Identifier: MIT
// What becomes of a plan, in sentences.
#pragma once

#include <string>

#include "core/planning/planning.h"

namespace gaitsmith::shell {

/// "Endpoint 4", "The centre of mass", at the beginning of a sentence.
[[nodiscard]] std::string PointWords(int endpoint);
/// "Endpoint 4 cannot be so high at 0.30 s: 1.20 m are missing."
/// @param plan of the miss
[[nodiscard]] std::string MissWords(const PlanMiss&, const Plan& plan);
/// How near the played motion comes to the marks of its plan.
[[nodiscard]] std::string PlayedWords(const PlanReport&);

}  // namespace gaitsmith::shell
