// SPDX-License-Identifier: MIT
// The distribution of a population's fitness in a few numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace gaitsmith {

struct Spread {
  std::int32_t members;  // members with a real motion, at least 2
  float least, lower_quartile, median, upper_quartile, best;
};

/// Quantiles between two members are interpolated. Members without a real motion (kNoMotion and below, NaN)
/// are left out, because a single one would hide the differences between the others.
/// @return nothing if fewer than two members remain
[[nodiscard]] std::optional<Spread> SpreadOf(std::vector<float> fitness);

}  // namespace gaitsmith
