// SPDX-License-Identifier: MIT
// The table of parameters against the document format: it is complete, and every entry sets its own field.
#include "shell/words/search_parameters.h"

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <iterator>
#include <set>
#include <string>

#include "core/document/document.h"
#include "core/document/json.h"
#include "core/document/json_value.h"
#include "shell/words/algorithm_words.h"
#include "tests/scene.h"

namespace gaitsmith::shell::test {

namespace {

// Paths and values of all members below this one, except objects.
void Leaves(const JsonValue& value, const std::string& path,
            std::set<std::pair<std::string, std::string>>& out) {
  if (value.kind != JsonValue::Kind::kObject) {
    out.insert({path, value.text});
    return;
  }
  for (std::size_t i = 0; i < value.names.size(); ++i)
    Leaves(value.items[i], path + "." + value.names[i], out);
}

std::set<std::pair<std::string, std::string>> LeavesOf(const SearchSettings& search) {
  Document document;
  document.figure = gaitsmith::test::ShippedFigure("mr-star-man");
  document.search = search;
  const auto json = ParseJson(EncodeJson(document));
  REQUIRE(json);
  std::set<std::pair<std::string, std::string>> leaves;
  Leaves(*json->Find("search"), "", leaves);
  return leaves;
}

// Settings that all differ from the defaults, so that all fields are written.
SearchSettings Unusual() {
  SearchSettings search;
  search.algorithm = Algorithm::kShc;  // uses no other algorithm's parameters
  search.genetic.rates.mutation = 0.5f;
  search.torus.side = 5;
  search.refine.step = 0.5f;
  search.cma.step = 0.5f;
  search.elites.bins = 5;
  search.two_stage.kept = 7;
  search.difference.weight = 0.8f;
  return search;
}

void Change(SearchSettings& search, const SearchParameter& parameter) {
  if (const auto* whole = std::get_if<WholeParameter>(&parameter.kind)) {
    int& field = whole->field(search);
    field = field == whole->high ? whole->low : whole->high;
  } else if (const auto* real = std::get_if<RealParameter>(&parameter.kind)) {
    real->field(search) = static_cast<float>(0.25 * real->low + 0.75 * real->high);
  } else {
    const auto& choice = std::get<ChoiceParameter>(parameter.kind);
    choice.set(search, 1 - std::min(1, choice.get(search)));
  }
}

}  // namespace

TEST_CASE("parameters: every parameter in documents has its own widget", "[shell][parameters]") {
  std::set<std::string> reached = {".algorithm", ".seed", ".evaluations", ".start"};  // of all searches
  std::set<std::string_view> ids;
  std::set<const SearchParameter*> all;
  for (std::size_t i = 0; i < kAlgorithmNames.size(); ++i) {
    const auto algorithm = static_cast<Algorithm>(i);
    for (const auto& list : {ParametersOf(algorithm), VariationOf(algorithm)})
      all.insert(list.begin(), list.end());
  }
  for (const SearchParameter* parameter : all) {
    CAPTURE(parameter->id);
    CHECK(ids.insert(parameter->id).second);
    CHECK(std::string_view(parameter->line).ends_with('.'));
    SearchSettings search = Unusual();
    const auto before = LeavesOf(search);
    Change(search, *parameter);
    const auto after = LeavesOf(search);
    std::set<std::pair<std::string, std::string>> changed;
    std::ranges::set_difference(after, before, std::inserter(changed, changed.end()));
    REQUIRE(changed.size() == 1);
    CHECK(reached.insert(changed.begin()->first).second);
  }
  for (const auto& [path, value] : LeavesOf(Unusual())) {
    CAPTURE(path);
    CHECK((path == ".start" || reached.contains(path)));
  }
  CHECK(reached.contains(".cma.genes"));
}

TEST_CASE("parameters: defaults are within the ranges of the panel", "[shell][parameters]") {
  SearchSettings standard;
  for (std::size_t i = 0; i < kAlgorithmNames.size(); ++i) {
    const auto algorithm = static_cast<Algorithm>(i);
    for (const auto& list : {ParametersOf(algorithm), VariationOf(algorithm)}) {
      for (const SearchParameter* parameter : list) {
        CAPTURE(parameter->id);
        if (const auto* whole = std::get_if<WholeParameter>(&parameter->kind)) {
          CHECK(whole->field(standard) >= whole->low);
          CHECK(whole->field(standard) <= whole->high);
        } else if (const auto* real = std::get_if<RealParameter>(&parameter->kind)) {
          CHECK(static_cast<double>(real->field(standard)) >= real->low);
          CHECK(static_cast<double>(real->field(standard)) <= real->high);
        }
      }
    }
    CHECK(*WordsOf(algorithm).line != '\0');
  }
}

TEST_CASE("parameters: Fit makes any setting valid", "[shell][parameters]") {
  for (std::size_t i = 0; i < kAlgorithmNames.size(); ++i) {
    const auto algorithm = static_cast<Algorithm>(i);
    Document document;
    document.figure = gaitsmith::test::ShippedFigure("mr-star-man");
    document.search.evaluations = 10;
    document.search.algorithm = algorithm;
    for (const SearchParameter* parameter : ParametersOf(algorithm)) {
      CAPTURE(kAlgorithmNames[i], parameter->id);
      if (const auto* whole = std::get_if<WholeParameter>(&parameter->kind))
        whole->field(document.search) = whole->high;
      Fit(document.search);
      CHECK(Validate(document));
    }
  }
  SearchSettings cma;
  cma.cma.population = 1;  // one step up from 0 (automatic)
  Fit(cma);
  CHECK(cma.cma.population == 4);
  cma.cma.population = 3;  // one step down from 4
  Fit(cma);
  CHECK(cma.cma.population == 0);
}

}  // namespace gaitsmith::shell::test
