// SPDX-License-Identifier: MIT
// How the fitness of a population scatters, in a few numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace gaitsmith {

struct Spread {
  std::int32_t members;  // that have a motion, at least 2
  float least, lower_quartile, median, upper_quartile, best;
};

/// Quantiles between two members are interpolated. Members without a motion (kNoMotion and below, NaN) do not
/// count: one of them would bury all others.
/// @return nothing for fewer than two that count
[[nodiscard]] std::optional<Spread> SpreadOf(std::vector<float> fitness);

}  // namespace gaitsmith
