// SPDX-License-Identifier: MIT
// How the Lab draws each algorithm, the same in every run: a hue, and a solid or a dashed line.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/search/search.h"

namespace gaitsmith::shell {

inline constexpr int kAlgorithmHues = 10;  // the rule colours (Theme::Rule) repeat after the tenth

struct AlgorithmLook {
  int hue;  // a rule colour, [0, kAlgorithmHues)
  bool dashed = false;
  bool operator==(const AlgorithmLook&) const = default;
};

/// In the order of Algorithm. People tell about ten hues apart, so the next algorithms use the first hues
/// again, with dashes. None of these has the hue of the algorithm that it is most like, since such two are
/// often compared.
inline constexpr auto kAlgorithmLooks = std::to_array<AlgorithmLook>({
    {.hue = 0},                  // RG&T
    {.hue = 1},                  // SPHC
    {.hue = 2},                  // GGA
    {.hue = 3},                  // SSGA
    {.hue = 4},                  // SHC
    {.hue = 5},                  // MPGA
    {.hue = 6},                  // Nelder-Mead
    {.hue = 7},                  // Powell
    {.hue = 8},                  // CMA-ES
    {.hue = 9},                  // MAP-Elites
    {.hue = 3, .dashed = true},  // Two-stage
    {.hue = 2, .dashed = true},  // Pose cycle
    {.hue = 0, .dashed = true},  // DE
    {.hue = 1, .dashed = true},  // NSGA-II
    {.hue = 4, .dashed = true},  // CMA-MAE
});
static_assert(kAlgorithmLooks.size() == kAlgorithmNames.size(), "every algorithm needs its look");
static_assert(std::ranges::all_of(kAlgorithmLooks,
                                  [](const AlgorithmLook& look) {
                                    return look.hue >= 0 && look.hue < kAlgorithmHues &&
                                           std::ranges::count(kAlgorithmLooks, look) == 1;
                                  }),
              "every algorithm needs a look of its own");

[[nodiscard]] constexpr const AlgorithmLook& LookOf(Algorithm algorithm) {
  return kAlgorithmLooks[static_cast<std::size_t>(algorithm)];
}

}  // namespace gaitsmith::shell
