// SPDX-License-Identifier: MIT
// The table of all search parameters, with name, explanation and range. The panel is built from it, and a
// test compares it with the document format.
#pragma once

#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "core/search/search.h"

namespace gaitsmith::shell {

struct WholeParameter {
  int low, high, step;
  int& (*field)(SearchSettings&);
};
struct RealParameter {
  double low, high, step;
  bool logarithmic;
  float& (*field)(SearchSettings&);
};
/// A parameter with a few options.
struct ChoiceParameter {
  std::span<const char* const> options;  // to be translated, as are label and line
  int (*get)(const SearchSettings&);
  void (*set)(SearchSettings&, int);
};

struct SearchParameter {
  std::string_view id;  // id of its widget, e.g. "search/population"
  const char* label;    // with the unit, if any
  const char* line;     // explanation
  std::variant<WholeParameter, RealParameter, ChoiceParameter> kind;
  bool (*matters)(const SearchSettings&) = nullptr;  // null: always
};

/// The parameters specific to this algorithm, in the order of the panel. Excludes those of all searches
/// (budget, seed, start).
[[nodiscard]] std::vector<const SearchParameter*> ParametersOf(Algorithm);
/// The parameters of random initialisation and mutation, shared by several searches.
[[nodiscard]] std::vector<const SearchParameter*> VariationOf(Algorithm);

/// Changes the settings to the nearest valid ones: the first population fits into the budget, and a
/// population of CMA-ES is at least 4.
void Fit(SearchSettings&);

}  // namespace gaitsmith::shell
