// SPDX-License-Identifier: MIT
#include "core/search/spread.h"

#include <algorithm>

#include "core/search/search.h"

namespace gaitsmith {

std::optional<Spread> SpreadOf(std::vector<float> fitness) {
  std::erase_if(fitness, [](float value) { return !(value > kNoMotion); });
  if (fitness.size() < 2) return std::nullopt;
  std::ranges::sort(fitness);
  const auto quantile = [&](double share) {
    const double place = share * static_cast<double>(fitness.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, fitness.size() - 1);
    const auto low = static_cast<double>(fitness[below]);
    return static_cast<float>(low + (place - static_cast<double>(below)) *
                                        (static_cast<double>(fitness[above]) - low));
  };
  return Spread{.members = static_cast<std::int32_t>(fitness.size()),
                .least = fitness.front(),
                .lower_quartile = quantile(0.25),
                .median = quantile(0.5),
                .upper_quartile = quantile(0.75),
                .best = fitness.back()};
}

}  // namespace gaitsmith
