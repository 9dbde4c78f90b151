// SPDX-License-Identifier: MIT
// Every parameter of every search: its name, what it does in one line, what it may be. The panel is made from
// this table, and a test compares it with what documents hold.
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
/// One of a few.
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

/// What this algorithm alone is told, in the order of the panel. What all are told (budget, seed, start) is
/// not among them.
[[nodiscard]] std::vector<const SearchParameter*> ParametersOf(Algorithm);
/// How it draws controllers at random and perturbs them: the operators that searches share.
[[nodiscard]] std::vector<const SearchParameter*> VariationOf(Algorithm);

/// The nearest settings that are valid: a first population must fit into the budget, CMA-ES has no population
/// of less than four.
void Suit(SearchSettings&);

}  // namespace gaitsmith::shell
