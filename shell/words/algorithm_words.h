// SPDX-License-Identifier: MIT
// Names and descriptions of the searches.
#pragma once

#include <array>
#include <string>

#include "core/search/search.h"

namespace gaitsmith::shell {

struct AlgorithmWords {
  std::string name;   // "SPHC", in English as in documents
  const char* title;  // "SPHC: hill climbing, reseeded", to be translated
  const char* line;   // one sentence, to be translated
};

/// In the order of Algorithm.
[[nodiscard]] const std::array<AlgorithmWords, kAlgorithmNames.size()>& AlgorithmTexts();
/// The first of the table, which everybody sees. Further ones are for those who ask for them.
inline constexpr int kListedAlgorithms = static_cast<int>(Algorithm::kPoseCycle) + 1;

[[nodiscard]] const AlgorithmWords& WordsOf(Algorithm);
/// The short name in the language of the page. Most are the same in all.
[[nodiscard]] std::string AlgorithmName(Algorithm);

/// Whether a search starts from a single genome, so that it can start from a given controller.
[[nodiscard]] bool RefinesOne(Algorithm);

}  // namespace gaitsmith::shell
