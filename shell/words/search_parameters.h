// SPDX-License-Identifier: MIT
// Every parameter of every search: its name, a line that explains it, and its range. The panel is built from
// this table, and a test compares the table with the document format.
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
  std::string_view id;  // of its widget, e.g. "search/population"
  const char* label;    // with its unit, if it has one
  const char* line;     // what it does
  std::variant<WholeParameter, RealParameter, ChoiceParameter> kind;
};

/// The parameters of this algorithm alone, in the order of the panel. Excludes the parameters of all searches
/// (budget, seed, start).
[[nodiscard]] std::vector<const SearchParameter*> ParametersOf(Algorithm);
/// The operators that draw and change controllers at random, shared by several searches.
[[nodiscard]] std::vector<const SearchParameter*> VariationOf(Algorithm);

/// Changes the settings to the nearest valid ones: a first population must fit into the budget, and a
/// population of CMA-ES is at least 4.
void Fit(SearchSettings&);

}  // namespace gaitsmith::shell
