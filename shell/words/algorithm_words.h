// SPDX-License-Identifier: MIT
// The searches as people read them.
#pragma once

#include <array>
#include <string>

#include "core/search/search.h"

namespace gaitsmith::shell {

struct AlgorithmWords {
  std::string name;   // "SPHC"; the page translates it
  const char* title;  // "SPHC: hill climbing, reseeded", to be translated
  const char* line;   // one sentence, to be translated
};

/// In the order of Algorithm.
[[nodiscard]] const std::array<AlgorithmWords, kAlgorithmNames.size()>& AlgorithmTexts();
[[nodiscard]] const AlgorithmWords& WordsOf(Algorithm);

/// Whether a search works from one genome onwards, so that giving it one makes sense.
[[nodiscard]] bool RefinesOne(Algorithm);

}  // namespace gaitsmith::shell
